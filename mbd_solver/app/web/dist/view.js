/* Holds three.js, Copyright (c) 2010-2026 three.js authors, and uPlot, Copyright (c) 2022 Leon Sorokin. MIT licence, of both:
Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE. */
(()=>{var Md='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var bd=`:root{color-scheme:light dark;--page:#fff;--ink:#222;--soft:#555;--line:#ccc;--field:#eef3f8;--panel:#fffffff0;--warn:#fff0e0;--stage:#eef1f4;--glow:#fff;--good:#136b2b;--bad:#a32018;--joint:#1f4e79;--body:#333;--strut:#7a4b00;--force:#9c0056}
@media screen and (prefers-color-scheme:dark){:root:not(:has(.picture)){--page:#16191d;--ink:#e4e6e8;--soft:#a3a9b0;--line:#3c444d;--field:#263040;--panel:#1d2228f0;--warn:#3a2a17;--stage:#1d2228;--glow:#000;--good:#7bd88f;--bad:#ff9c92;--joint:#8ec5ff;--body:#e8e8e8;--strut:#f0b53a;--force:#ff8cc8}}
.plots{font:13px/1.35 sans-serif;color:var(--ink)}
.plots .chooser{position:relative}
.plots input{width:100%;box-sizing:border-box;padding:.4em .6em;font:inherit;border:1px solid var(--line);border-radius:4px}
.plots ul{list-style:none;margin:0;padding:0}
.plots .found{position:absolute;z-index:5;left:0;right:0;max-height:45vh;overflow:auto;background:var(--page);border:1px solid var(--line);box-shadow:0 4px 12px #0003}
.plots .found li{padding:.35em .7em;cursor:pointer}
.plots .found li:hover{background:var(--field)}
.plots .found li.on{font-weight:bold}
.plots .chosen{margin:.4em 0;columns:24em}
.plots .chosen li{display:flex;align-items:center;gap:.4em;break-inside:avoid}
.plots .chosen li span:nth-child(2){flex:1;overflow-wrap:anywhere}
.plots .chosen output{font-variant-numeric:tabular-nums;white-space:nowrap}
.plots .chosen button{border:0;background:none;cursor:pointer;font-size:1.1em;padding:0 .3em;color:var(--soft)}
.plots .dot{flex:none;width:.8em;height:.8em;border-radius:50%}
.plots .unit{color:var(--soft);margin:.3em 0 0 .3em}
.plots .now{position:absolute;left:0;top:0;bottom:0;width:0;border-left:1.5px solid #c2006b;pointer-events:none;will-change:transform}
.plots .judged{border-collapse:collapse;width:100%;margin:.4em 0}.plots .judged td{padding:.2em .4em;border-bottom:1px solid var(--line);vertical-align:top}.plots .judged td:last-child{text-align:right;white-space:nowrap;font-variant-numeric:tabular-nums}.plots .judged .met{color:var(--good)}.plots .judged .missed{color:var(--bad);font-weight:bold}.plots .judged button{font:inherit;border:0;background:none;padding:0;color:inherit;text-decoration:underline dotted;cursor:pointer}.plots .judged .wide td{text-align:left;white-space:normal}.plots summary{cursor:pointer;font-weight:bold}
.footfall-figures{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,30em),1fr));gap:1.2em 1.5em}.footfall-figures figure{margin:0;min-width:0;break-inside:avoid}.footfall-figures figure:only-child{grid-column:1/-1}.footfall-figures figcaption{font-weight:bold;color:var(--ink)}.footfall-figures .chosen{display:flex;flex-wrap:wrap;gap:0 1em}.footfall-figures output{min-width:4em}
.footfall-mechanism{display:block;width:100%;max-width:50em;background:var(--stage);border-radius:4px}
@media print{:root{color-scheme:light}.plots .chooser input,.plots .chosen button,.u-over,.u-under{display:none}.uplot,.u-wrap,.u-wrap canvas{width:100%!important;height:auto!important}}
`;var Sd=`html,body{margin:0;height:100%;overflow:hidden}
body{font:13px/1.4 sans-serif;color:var(--ink);background:var(--page);display:grid;grid-template:auto minmax(0,1fr) auto / minmax(0,1fr) minmax(300px,30vw);grid-template-areas:"head head" "stage plots" "bar bar"}
header{grid-area:head;max-height:18vh;overflow:auto;padding:.5em 1em;border-bottom:1px solid var(--line)}
header h1{font-size:1.1em;margin:0;display:inline}
header span{color:var(--soft);margin-left:1em}
.warning{background:var(--warn);border-left:4px solid #d55e00;padding:.15em .7em;margin:.4em 0 0}
.warning summary{cursor:pointer;overflow:hidden;text-overflow:ellipsis;white-space:nowrap}
.warning p{margin:.3em 0}
#footfall-stage{grid-area:stage;position:relative;overflow:hidden;background:var(--stage)}
#footfall-stage canvas{display:block;width:100%!important;height:100%!important;touch-action:none}
#footfall-plots{grid-area:plots;overflow:auto;padding:.6em;border-left:1px solid var(--line);background:var(--page)}
#footfall-bar{grid-area:bar;display:flex;align-items:center;gap:.5em;padding:.5em 1em;border-top:1px solid var(--line);background:var(--page)}
#footfall-bar input{flex:1;min-width:4em}
#footfall-bar button,#footfall-bar select{font:inherit;min-width:2.4em;height:2.4em}
.progress{margin-left:1em;color:var(--good);font-variant-numeric:tabular-nums}.progress.lost{color:var(--bad)}.live{color:#777}.live.on{color:#c1121f;font-weight:bold}
.play{width:3.2em}
.clock{font-variant-numeric:tabular-nums;min-width:6.5em;text-align:right}
#footfall-panel{position:absolute;top:.6em;left:.6em;background:var(--panel);border:1px solid var(--line);border-radius:4px;padding:.4em .7em;max-width:16em;max-height:calc(100% - 2.4em);overflow:auto}
#footfall-panel summary{cursor:pointer;font-weight:bold}
#footfall-panel label{display:flex;gap:.5em;align-items:center;margin:.35em 0}
#footfall-panel label span:first-child{min-width:3.6em}
#footfall-panel select,#footfall-panel button{font:inherit}
#footfall-panel .check span{min-width:0}
.clip{display:flex;flex-wrap:wrap;align-items:center;gap:0 .5em}
.clip input[type=range]{flex:1;min-width:6em}
.views{display:flex;gap:.3em;margin:.4em 0}
.legend{display:flex;gap:.5em;height:6.5em;margin:.5em 0}
.scale{width:1em;border:1px solid #888}
.ends{display:flex;flex-direction:column;justify-content:space-between}
.note{color:var(--soft)}
#footfall-loading{position:absolute;bottom:.6em;left:.6em;background:var(--panel);padding:.2em .6em;border-radius:4px}
#footfall-missing{position:absolute;inset:auto 1em 1em auto;max-width:30em;background:var(--panel);padding:.5em .8em;border-radius:4px}
#footfall-fault{position:fixed;inset:30% 15% auto;background:var(--warn);border-left:4px solid #d55e00;padding:1em;z-index:9}
.keys{position:fixed;inset:10% auto auto 50%;transform:translateX(-50%);background:var(--page);border:1px solid #888;box-shadow:0 6px 20px #0004;padding:1em 1.4em;z-index:8;max-width:30em}
.keys dl{display:grid;grid-template-columns:auto 1fr;gap:.2em 1em;margin:0}
.keys dt{font-weight:bold}.keys dd{margin:0}
#footfall-panel .layers{margin-left:1.4em}
#footfall-panel .layers label{margin:.15em 0}
#footfall-panel select{max-width:11em}
.views{flex-wrap:wrap}
.corner{position:absolute;right:.4em;top:.4em;width:120px;height:120px;pointer-events:none;font:bold 11px sans-serif}
.names span{position:absolute;left:0;top:0;white-space:nowrap;font-size:11px;color:var(--joint);text-shadow:0 0 2px var(--glow),0 0 2px var(--glow),0 0 2px var(--glow);pointer-events:none}
.names .body{font-weight:bold;color:var(--body)}.names .strut,.names .spring{color:var(--strut)}.names .drive,.names .force{color:var(--force)}
#footfall-caption{display:none}
.picture{display:block;height:100vh}
.picture header,.picture #footfall-plots,.picture #footfall-bar,.picture #footfall-panel,.picture #footfall-missing,.picture #footfall-loading{display:none}
.picture #footfall-stage{width:100vw;height:100vh}
.picture #footfall-caption{display:block;position:absolute;left:.8em;top:.6em;font-size:17px;color:#222;text-shadow:0 0 3px #fff,0 0 3px #fff;white-space:pre-wrap;font-variant-numeric:tabular-nums}
.picture #footfall-caption .note{font-size:13px}
.picture .legends{position:absolute;right:1em;bottom:.6em;display:flex;gap:1em;background:#ffffffd0;padding:0 .6em;border-radius:4px}
.still{grid-template:auto minmax(0,1fr) / minmax(0,1fr);grid-template-areas:"head" "stage"}
.still #footfall-plots,.still #footfall-bar{display:none}
[hidden]{display:none!important}
@media (max-width:800px){body{grid-template:auto minmax(0,55fr) minmax(0,45fr) auto / minmax(0,1fr);grid-template-areas:"head" "stage" "plots" "bar"}#footfall-plots{border-left:0;border-top:1px solid var(--line)}#footfall-bar{flex-wrap:wrap}#footfall-bar input{flex:1 0 100%;order:-1}#footfall-bar .clock{margin-left:auto}}
`;function za(i){if(Uint8Array.fromBase64)return Uint8Array.fromBase64(i);let t=atob(i),e=new Uint8Array(t.length);for(let n=0;n<e.length;++n)e[n]=t.charCodeAt(n);return e}async function Va(i){let t=new Blob([i]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(t).arrayBuffer())}var rs=class{constructor(t){this.last=new Uint16Array(t)}next(t){let e=this.last.length;if(t.length!==2*e)throw new Error(`a frame has ${t.length} bytes, expected ${2*e}`);let n=new Uint16Array(e);for(let s=0;s<e;++s){let r=t[s]|t[e+s]<<8;n[s]=this.last[s]+(r>>>1^-(r&1))}return this.last=n,n}};function Jn(i,t){let e=i.length/4,n=new Uint8Array(i.length);for(let s=0;s<4;++s)for(let r=0;r<e;++r)n[4*r+s]=i[s*e+r];return new t(n.buffer)}function wd(){return JSON.parse(document.getElementById("footfall-run").textContent)}var B0=5;async function k0(i){for(;;){let t=document.readyState!=="loading",e=document.getElementById(i);if(t||e?.nextElementSibling)return e;await new Promise(n=>setTimeout(n,B0))}}var Hn=new Map;async function os(i){if(Hn.has(i))return Hn.get(i);let t=await k0(`footfall-${i}`);if(!t)throw new Error(`the page lacks its part "${i}"; was the file cut off?`);let e=t.textContent;return t.remove(),Va(za(e))}async function Fo(i,t){return Jn(await os(i),t)}async function Uh(i,t=""){let{names:e,units:n,rows:s}=i.history,r=await Fo(`${t}history`,Float32Array),o=new Map;return e.forEach((a,l)=>o.set(a,{name:a,unit:n[l],values:r.subarray(l*s,(l+1)*s)})),{time:Float64Array.from(i.history.time),columns:o}}async function Ed(i){return i.other?{history:await Uh(i.other,"other-"),names:[i.name,i.other.name]}:null}function er(i,t){let e=0,n=i.length-1;for(;e<n;){let s=e+n+1>>1;i[s]<=t?e=s:n=s-1}return e}function Ga(i,t,e){let n=er(i.time,e);if(n+1>=i.time.length||e<=i.time[n])return t[n];let s=i.time[n+1]-i.time[n],r=s>0?(e-i.time[n])/s:1;return t[n]+r*(t[n+1]-t[n])}var Ad=!1,Cd=()=>!Ad&&window.matchMedia("(prefers-color-scheme: dark)").matches&&!/picture=1/.test(window.location.hash);function Rd(i,t){window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change",i,{signal:t});for(let e of["beforeprint","afterprint"])window.addEventListener(e,()=>{Ad=e==="beforeprint",i()},{signal:t})}var Fh=["#0072b2","#d55e00","#009e73","#cc79a7","#e69f00","#56b4e9","#000000","#999999"],z0=["#4da3ff","#ff8c42","#2fcf9f","#e3a0c6","#f0b53a","#7fcdf5","#f2f2f2","#aaaaaa"],Pd=i=>(Cd()?z0:Fh)[i],as=()=>Cd()?{ink:"#d5d9dd",grid:"#3a424b",stage:1909288,lines:4476247,axes:8030100,limit:"#ff6b6b"}:{ink:"#333",grid:"#e4e4e4",stage:15659508,lines:12963027,axes:8951459,limit:"#b91c1c"},Td=["#8fa6bd","#c98b5f","#7fb09a","#c79bb5","#d9b668","#93c4dd","#9a9a9a","#b7b08f"];function Id(i){let t=i.map(n=>n.replace(/\d+/g,"#")),e=[...new Set(t)];return t.map(n=>Td[e.indexOf(n)%Td.length])}var Xi={sand:{shares:[0,.1,.3,.65,1],stops:[[233,223,199],[214,178,104],[127,174,138],[31,111,168],[46,20,90]]},stress:{shares:[0,.25,.5,.75,1],stops:[[0,34,78],[65,77,107],[124,123,120],[188,175,111],[254,232,56]]}};function Ld(i){return`linear-gradient(to top, ${i.stops.map((t,e)=>`rgb(${t.join(",")}) ${100*i.shares[e]}%`).join(", ")})`}function Oh(i=window.location.hash){let t={};for(let e of i.replace(/^#/,"").split("&")){let[n,...s]=e.split("=");n&&(t[decodeURIComponent(n)]=decodeURIComponent(s.join("=")))}return t}function Dd(i){return`#${Object.entries(i).filter(([,e])=>e!==""&&e!==void 0&&e!==null).map(([e,n])=>`${e}=${encodeURIComponent(n).replace(/%2C/g,",").replace(/%3A/g,":")}`).join("&")}`}var Bh=i=>(i??"").split(",").map(Number).filter(Number.isFinite);var V0=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"\xB5"]],G0=/^(N|J|Pa|W|N m)$/,H0=/^(m|rad|s|m\/s|rad\/s)$/;function Ha(i,t){let e=G0.test(i);if(!(t>0)||!(e||H0.test(i)))return{factor:1,unit:i==="-"?"":i};for(let[n,s]of V0)if(t>=n&&(e||n<=1))return{factor:1/n,unit:s+i};return{factor:1e6,unit:`\xB5${i}`}}function Kn(i,t=4){if(i===0)return"0";let e=Math.abs(i),n=Number(i.toPrecision(t));return e>=1e5||e<.001?n.toExponential():String(n)}function kh(i,t){let{factor:e,unit:n}=Ha(t,Math.abs(i));return`${Kn(i*e)} ${n}`.trim()}var W0=[["space","play, pause"],["\u2190 \u2192","one frame back, on"],["Home End","start, end"],["+ \u2212","faster, slower"],["c","clip plane across x, y, z, none"],["[ ]","move the clip plane"],["f","ground forces"],["j","symbols of joints, struts, drives, forces"],["n","names"],["l","this moment and camera into the address of the page"],["g","next colour of the grains"],["b","next colour of the bodies"],["s","smooth, or frame by frame"],["1 2 3 4 5","from the front, the side, above, all, the mechanism"],["?","this list"]];function he(i,t={},...e){let n=document.createElement(i);for(let[s,r]of Object.entries(t))s.startsWith("on")?n.addEventListener(s.slice(2),r):n.setAttribute(s,r);return n.append(...e),n}function Oo(i,t,e,n){let s=he("select",{onchange:()=>n(s.value),"aria-label":i});for(let{value:r,text:o}of t)s.append(he("option",r===e?{value:r,selected:""}:{value:r},o));return{select:s,row:he("label",{},he("span",{},i),s)}}var zh=i=>`ground forces, length ~ sqrt(F), max ${kh(i,"N")}`,Wa=class i{constructor(t,e,n,s){Object.assign(this,{run:t,stage:e,player:n}),this.frames=0,this.bar(),e.scene&&this.panel(),this.help(),n.onPlaying=r=>{this.button.textContent=r?"\u275A\u275A":"\u25B6",this.button.setAttribute("aria-label",r?"pause":"play"),e.suitRate(0,r)},document.addEventListener("keydown",r=>this.key(r),{signal:s})}end(){for(let t of["panel","bar","caption"])document.getElementById(`footfall-${t}`).replaceChildren();this.keys.remove()}addLive(){let{player:t}=this;this.live?.remove(),t.follows&&(this.live=he("button",{class:"live",onclick:()=>t.setLive(!0),title:"stay at the end of the run"},"\u25CF live"),document.getElementById("footfall-bar").append(this.live),t.onLive=e=>this.live.classList.toggle("on",e),t.onLive(t.live))}tellForces(){let t=this.stage.arrows?.largest>0?this.stage.arrows.largest:0;!this.forces||!(t>0)||(this.forces.hidden=!1,this.forces.querySelector("span").textContent=zh(t))}bar(){let{player:t}=this;this.button=he("button",{onclick:()=>t.play(),"aria-label":"play",class:"play"},"\u25B6"),this.slider=he("input",{type:"range",min:0,max:1e4,value:0,step:1,"aria-label":"time",oninput:()=>{t.play(!1),t.seek(t.start+this.slider.value/1e4*(t.end-t.start))}}),this.clock=he("output",{class:"clock"});let e=[.05,.1,.25,.5,1,2,4].map(s=>({value:String(s),text:`\xD7 ${s}`})),n=Oo("speed",e,"1",s=>t.speed=Number(s));this.speed=n.select,document.getElementById("footfall-bar").append(this.button,he("button",{onclick:()=>t.step(-1),"aria-label":"one frame back"},"\u2039"),he("button",{onclick:()=>t.step(1),"aria-label":"one frame on"},"\u203A"),this.slider,this.clock,this.speed,he("button",{onclick:()=>this.keys.hidden=!this.keys.hidden,"aria-label":"keys"},"?"))}panel(){let{stage:t,run:e}=this,n=[];if(this.legend=he("div",{class:"legends"}),t.grains){let a=t.grains.colours(),l=Oo("grains",a.map(c=>({value:c.name,text:c.name})),a[0].name,()=>this.colourGrains());this.grainColour=l.select,n.push(l.row)}if(t.bodies){let a=[{value:"body",text:"by body"}];e.bodies.stress>0&&a.push({value:"stress",text:"stress"});let l=Oo("bodies",a,a[0].value,()=>this.colourBodies());this.bodyColour=l.select,n.push(l.row)}let s=Oo("clip",[["","none"],["x","across x"],["y","across y"],["z","across z"]].map(([a,l])=>({value:a,text:l})),"",a=>this.setClip({axis:a}));this.clip=s.select,this.clipPlace=he("input",{type:"range",min:0,max:1,step:.005,value:.5,"aria-label":"place of the clip plane",oninput:()=>this.setClip({share:Number(this.clipPlace.value)})}),this.clipText=he("output"),this.clipMore=he("div",{class:"clip",hidden:""},this.clipPlace,this.clipText,this.check("other side",!1,a=>this.setClip({flip:a})),this.check("bodies too",!1,a=>this.setClip({bodies:a}))),n.push(s.row,this.clipMore),(t.arrows?.largest>0||e.live&&t.arrows)&&(this.forces=this.check(zh(t.arrows.largest),!0,a=>{t.arrows.object.visible=a,t.setTime(t.time)}),this.forces.hidden=!(t.arrows.largest>0),n.push(this.forces)),t.other&&n.push(this.ghost=this.check(`ghost: ${e.other.name}`,!0,a=>{t.other.object.visible=a,t.wish()})),t.symbols&&this.symbolRows(n),n.push(this.smooth=this.check("smooth between frames",!0,a=>{t.smooth=a,t.setTime(t.time)}));let r=[["front",-90,4],["side",0,4],["above",-90,89.9],["all",-65,24]];this.views=r.map(([a,l,c])=>he("button",{onclick:()=>t.look(l,c)},a)),t.mechanism&&this.views.push(he("button",{onclick:()=>t.lookAtMechanism(-65,18)},"mechanism"));let o=[`grid: squares of ${Kn(t.square)} m`];t.slope>.001&&o.push(`slope: ${Kn(t.slope*180/Math.PI,3)}\xB0`),t.grains&&o.push(`bands: initial depth, ${Kn(t.grains.layer)} m each`),this.notes=o,n.push(he("div",{class:"views"},...this.views,he("button",{onclick:()=>this.writeLink(),title:"this moment and camera into the address of the page"},"link")),this.legend,...o.map(a=>he("div",{class:"note"},a))),document.getElementById("footfall-panel").append(he("details",innerWidth>1500?{open:""}:{},he("summary",{},"show"),...n)),this.colourGrains(),this.colourBodies()}symbolRows(t){let{stage:e}=this,n=()=>e.setTime(e.time),s=this.symbols=this.check("symbols",!0,a=>{e.symbols.object.visible=a,n()});this.layers=new Map(e.symbols.layers().map(a=>[a.name,this.check(a.text,a.on,l=>{e.symbols.on[a.name]=l,n()})])),this.named=this.check("names",!1,a=>{e.overlay.named=a,e.wish()}),t.push(s,he("div",{class:"layers"},...this.layers.values(),this.named));let r=e.marks.list.filter(a=>a.kind==="body"||a.kind==="joint").map(a=>`${a.kind}:${a.name}`),o=Oo("track of",[{value:"",text:"no point"},...r.map(a=>({value:a,text:a.replace(":"," ")}))],"",a=>{e.symbols.setTrack(a),n()});this.track=o.select,t.push(o.row)}writeLink(){history.replaceState(null,"",Dd(this.entries()))}entries(){let{stage:t,player:e}=this,n={t:Number(e.time.toPrecision(6))};if(t.scene){let s=t.eye(),r=a=>String(Number(a.toFixed(3)));n.camera=[s.azimuth,s.elevation,s.zoom,...s.at].map(r).join(","),n.grains=this.grainColour?.value,n.bodies=this.bodyColour?.value;let o=[...this.layers??[]].filter(([,a])=>!a.querySelector("input").checked).map(([a])=>a);this.symbols&&!this.symbols.querySelector("input").checked&&o.push("symbols"),this.forces&&!this.forces.querySelector("input").checked&&o.push("arrows"),n.hide=o.join(","),n.track=this.track?.value,n.names=t.overlay.named?"1":"",t.clip.axis&&(n.clip=[t.clip.axis,Number(t.clip.share.toFixed(3))].join(","))}return n}follow(t){let{stage:e,player:n}=this,s=(l,c)=>l&&l.querySelector("input").checked!==c&&i.flip(l),r=(l,c)=>{!l||![...l.options].some(h=>h.value===c)||(l.value=c,l.dispatchEvent(new Event("change")))},[o]=Bh(t.t);if(o!==void 0&&n.seek(o),!e.scene)return;let a=Bh(t.camera);if(a.length>=2?e.look(a[0],a[1],a[2]>0?a[2]:1,a.length>=6?a.slice(3,6):null):t.camera==="mechanism"&&e.lookAtMechanism(-65,18),r(this.grainColour,t.grains),r(this.bodyColour,t.bodies),t.track!==void 0&&r(this.track,t.track.includes(":")||t.track===""?t.track:`body:${t.track}`),t.hide!==void 0){let l=t.hide.split(",");for(let[c,h]of this.layers??[])s(h,!l.includes(c));s(this.symbols,!l.includes("symbols")),s(this.forces,!l.includes("arrows")),e.grains&&(e.grains.object.visible=!l.includes("grains")),e.bodies&&(e.bodies.object.visible=!l.includes("bodies"))}if(t.names!==void 0&&s(this.named,t.names==="1"),t.clip!==void 0&&this.clip){let[l,c]=t.clip.split(",");r(this.clip,l),this.setClip({share:Number(c)>=0?Number(c):.5}),this.clipPlace.value=String(e.clip.share)}e.wish()}check(t,e,n){let s=he("input",{type:"checkbox",...e?{checked:""}:{},onchange:()=>n(s.checked)});return he("label",{class:"check"},s,he("span",{},t))}static flip(t){t?.querySelector("input").click()}setClip(t){let{stage:e}=this;e.setClip(t),this.clipMore.hidden=e.clip.axis==="",this.clipText.textContent=e.clip.axis?`${e.clip.axis} = ${Kn(e.clipAt,3)} m`:""}colourGrains(){this.stage.grains&&(this.stage.grains.setColour(this.grainColour.value),this.stage.wish(),this.legends())}colourBodies(){this.stage.bodies&&(this.stage.bodies.uniforms.uStress.value=this.bodyColour.value==="stress",this.stage.wish(),this.legends())}legends(){let t=[],e=(s,r,o,a)=>he("div",{class:"legend"},he("div",{class:"scale",style:`background:${Ld(r)}`}),he("div",{class:"ends"},he("span",{},kh(o,a)),he("span",{},s),he("span",{},"0"))),n=this.stage.grains?.colours().find(s=>s.name===this.grainColour.value);n?.largest>0&&t.push(e(`grains, ${n.name}`,Xi.sand,n.largest,n.unit)),this.bodyColour?.value==="stress"&&t.push(e("bodies, von Mises",Xi.stress,this.run.bodies.stress,"Pa")),this.legend.replaceChildren(...t)}showTime(t){let{player:e,stage:n}=this;this.slider.value=String(Math.round(1e4*(t-e.start)/(e.end-e.start||1))),this.clock.textContent=`${t.toFixed(4)} s`,e.playing&&++this.frames%2===0&&n.suitRate(e.rate(),!0)&&(e.drawn=[])}showCaption(t,e=0){let{run:n}=this,s=document.getElementById("footfall-caption");if(!s)return;let r=[n.title,n.history?`t = ${t.toFixed(n.digits??3)} s`:"reference configuration",e>1.01?`slowed ${Kn(e,3)} times`:e>0&&e<.99?`${Kn(1/e,3)} times as fast`:""],o=this.stage.arrows?.largest>0&&this.stage.arrows.object.visible?[zh(this.stage.arrows.largest)]:[];s.replaceChildren(he("div",{},r.filter(Boolean).join("   ")),...[...this.notes??[],...o].map(a=>he("div",{class:"note"},a))),this.legend&&this.legend.parentElement!==s.parentElement&&s.parentElement.append(this.legend)}showLoaded(){let t=this.stage.loaded();this.slider.style.setProperty("--loaded",`${100*t}%`),document.getElementById("footfall-loading").hidden=t>=1,document.getElementById("footfall-loading").textContent=`reading frames: ${Math.round(100*t)} %`}help(){let t=he("dl",{},...W0.flatMap(([n,s])=>[he("dt",{},n),he("dd",{},s)])),e="One finger or the left button turns, two fingers or the right button move, a pinch or the wheel zooms. A click into a plot goes to that time; a drag zooms it, a double click goes back.";this.keys=he("div",{class:"keys",hidden:"",onclick:()=>this.keys.hidden=!0},t,he("p",{},e)),document.body.append(this.keys)}key(t){if(t.ctrlKey||t.metaKey||t.altKey||/^(input|select|textarea)$/i.test(t.target.tagName)&&t.target.type!=="range"&&t.target.type!=="checkbox")return;let{player:e,stage:n}=this,s=(c,h)=>{c&&(c.selectedIndex=(c.selectedIndex+1)%c.options.length,h())},r=c=>{this.speed.selectedIndex=Math.min(this.speed.options.length-1,Math.max(0,this.speed.selectedIndex+c)),e.speed=Number(this.speed.value)},o=c=>{this.clip&&(this.clipPlace.value=String(Number(this.clipPlace.value)+c),this.setClip({share:Number(this.clipPlace.value)}))},l={" ":()=>e.play(),ArrowLeft:()=>e.step(-1),ArrowRight:()=>e.step(1),Home:()=>e.seek(e.start),End:()=>e.seek(e.end),"+":()=>r(1),"=":()=>r(1),"-":()=>r(-1),c:()=>s(this.clip,()=>this.setClip({axis:this.clip.value})),"[":()=>o(-.02),"]":()=>o(.02),f:()=>i.flip(this.forces),g:()=>s(this.grainColour,()=>this.colourGrains()),b:()=>s(this.bodyColour,()=>this.colourBodies()),s:()=>i.flip(this.smooth),1:()=>this.views?.[0].click(),2:()=>this.views?.[1].click(),3:()=>this.views?.[2].click(),4:()=>this.views?.[3].click(),5:()=>this.views?.[4]?.click(),j:()=>i.flip(this.symbols),n:()=>i.flip(this.named),l:()=>this.writeLink(),"?":()=>this.keys.hidden=!this.keys.hidden,Escape:()=>this.keys.hidden=!0}[t.key];l&&(t.preventDefault(),l())}};function nr(i,t,e={}){let n=document.createElement(i);t!==void 0&&(n.textContent=t);for(let[s,r]of Object.entries(e))n.setAttribute(s,r);return n}function Vh(i,t,e){let n=nr("details",void 0,e?{open:""}:{}),s=nr("table",void 0,{class:"judged"});return n.append(nr("summary",i),s),s.append(...t),n}var Gh=(i,t="")=>{let e=nr("tr",void 0,t?{class:t}:{});return e.append(...i.map(n=>{let s=nr("td");return s.append(n),s})),e};function Nd(i,t,e){let{requirements:n=[],peaks:s=[],differences:r=[]}=t,o=[];if(n.length>0){let a=n.filter(([,c])=>c!=="met").length,l=a===0?`Requirements: all ${n.length} met`:`Requirements: ${a} of ${n.length} not met`;o.push(Vh(l,n.map(([c,h])=>Gh([nr("span",c,{class:h==="met"?"met":"missed"})],"wide")),!0))}if(s.length>0&&o.push(Vh("Peaks and errors",s.map(([a,l,c])=>{let h=c===null?"":nr("button",`${l} at ${Number(c.toPrecision(4))} s`,{title:"show this time"});return c!==null&&h.addEventListener("click",()=>e(c)),Gh([a,c===null?l:h])}),!0)),t.other){let a=r.map(([l,c,h])=>Gh([l,`${c} \u2192 ${h}`]));o.push(Vh(a.length>0?`Scenes: ${a.length} keys differ`:"Scenes: no key differs",a,a.length<12))}i.append(...o)}var X0=.3,q0=.25,Hh=4200,Y0=3e8,kd=65534,Wh=65535,$0=65535,Z0=400,J0=10,K0=1e4,Is=async i=>Va(za(i));function Ud(i){let t=[0,1,2].map(n=>Math.min(...i.map(s=>s.low[n]))),e=[0,1,2].map(n=>Math.max(...i.map(s=>s.low[n]+s.size[n])));return{low:t,size:e.map((n,s)=>n-t[s])}}function Fd(i){let t=Math.max(...i.size)||1,e=i.size.map(n=>X0*Math.max(n,.3*t));return{low:i.low.map((n,s)=>n-e[s]),size:i.size.map((n,s)=>n+2*e[s])}}var Od=(i,t)=>[0,1,2].every(e=>t.low[e]>=i.low[e]&&t.low[e]+t.size[e]<=i.low[e]+i.size[e]);function Bd(i,t,e){let n=t.size[e]>0?i.size[e]/t.size[e]:0,s=t.size[e]>0?kd*(i.low[e]-t.low[e])/t.size[e]:0;return r=>Math.round(r*n+s)}var Xa=class{constructor(t,{rebuild:e,grown:n,told:s}){Object.assign(this,{head:t,rebuild:e,grown:n,told:s}),this.bodies=[],this.grains=[],this.end=0,this.over=!1,this.first=this.due=performance.now()+Z0,this.queue=Promise.resolve(),this.events=new EventSource("events");for(let r of["scene","columns","rows","bodies","grains","state"])this.events.addEventListener(r,o=>this.next(()=>this[`take_${r}`](JSON.parse(o.data))));this.events.onerror=()=>this.over||this.told({text:"no news from the run: the program that serves this page has ended, or is busy",lost:!0})}next(t){this.queue=this.queue.then(t).catch(e=>console.error(e))}async take_scene({run:t,chunks:e}){Object.assign(this.head,t),this.meshes=new Map;for(let[n,s]of Object.entries(e))this.meshes.set(n,Jn(await Is(s),Float32Array));this.stale=!0}take_state(t){if(this.over=t.over,t.over&&this.events.close(),this.told(t),this.stale)return this.renew()}take_columns({names:t,units:e,shown:n}){this.rows=0,this.capacity=Hh,this.shown=n,this.time=new Float64Array(Hh),this.history={time:this.time.subarray(0,0),columns:new Map(t.map((s,r)=>[s,{name:s,unit:e[r],values:new Float32Array(Hh)}]))},this.stale=!0}async take_rows({time:t,values:e}){let n=Jn(await Is(e),Float32Array),s=t.length;return this.rows+s>this.capacity&&this.widenHistory(this.rows+s),this.time.set(t,this.rows),[...this.history.columns.values()].forEach((r,o)=>r.values.set(n.subarray(o*s,(o+1)*s),this.rows)),this.rows+=s,this.history.time=this.time.subarray(0,this.rows),this.end=Math.max(this.end,t[s-1]),this.stale&&this.rows>1?this.renew():this.grown()}widenHistory(t){for(;this.capacity<t;)this.capacity*=2;let e=n=>{let s=new n.constructor(this.capacity);return s.set(n.subarray(0,this.rows)),s};this.time=e(this.time);for(let n of this.history.columns.values())n.values=e(n.values);this.stale=!0}async take_bodies({run:t,chunks:e}){t.bodyNames&&(this.names=t.bodyNames);let n={};if(t.bodies){let{points:l,cells:c,stress:h,stressed:u,box:f,times:d}=t.bodies;if(e["bodies-triangles"]){this.fixed=new Map;for(let x of["bodies-triangles","bodies-lines","bodies-cells","bodies-radius"])this.fixed.set(x,await Is(e[x]))}let g=new rs(3*l+(h>0?c:0)).next(await Is(e["bodies-0"]));Object.assign(n,{t:d[0],points:l,cells:c,stress:h,stressed:u,box:f,view:t.bodies.view,values:g})}if(t.marks&&Object.assign(n,{t:t.marks.times[0],list:t.marks.list,marksView:t.marks.view,marks:Jn(await Is(e.marks),Float32Array)}),n.t===void 0)return;this.bodies.push(n),this.end=Math.max(this.end,n.t);let s=this.run?.bodies,r=this.stage?.bodies||this.stage?.marks;if(!(r&&!this.stale&&(!n.box||s&&Od(s.box,n.box)&&n.stressed.every(l=>s.stressed.includes(l)))))return this.renew(!r);let a=n.box&&n.stress>s.stress;if(n.box){let l=this.bodyValues(n,s);s.times.push(n.t),this.stage.bodies.add(l)}return n.marks&&this.stage.marks&&(this.stage.marks.add(n.t,n.marks),this.stage.symbols.grow()),a?this.renewSoon():this.grown()}bodyValues(t,e){let n=t.points,s=new Uint16Array(3*n+(e.stress>0?t.cells:0));for(let r=0;r<3;++r){let o=Bd(t.box,e.box,r);for(let a=r*n;a<(r+1)*n;++a)s[a]=o(t.values[a])}if(t.stress>0)for(let r=0;r<t.cells;++r)s[3*n+r]=Math.min($0,Math.round(t.values[3*n+r]*t.stress/e.stress));return s}bodiesSpec(){let t=this.bodies.filter(a=>a.box);if(t.length===0)return null;let e=Math.max(...t.map(a=>a.stress)),[{points:n,cells:s,view:r}]=t,o={points:n,cells:s,view:r,times:t.map(a=>a.t),stress:1.5*e,stressed:[...new Set(t.flatMap(a=>a.stressed))],box:Fd(Ud(t.map(a=>a.box)))};for(let[a,l]of this.fixed)Hn.set(a,l);return t.forEach((a,l)=>Hn.set(`bodies-${l}`,this.bodyValues(a,o))),o}marksSpec(){let t=this.bodies.filter(s=>s.marks);if(t.length===0)return null;let e=t[0].marks.length,n=new Float32Array(e*t.length);return t.forEach((s,r)=>n.set(s.marks,e*r)),Hn.set("marks",n),{times:t.map(s=>s.t),list:t[0].list,view:t[0].marksView}}async take_grains({run:t,chunks:e}){let{count:n,times:s,box:r,view:o,numbers:a}=t.grains,l=new rs(n*(3+a.length)).next(await Is(e["grains-0"])),c=Jn(await Is(e["grains-ids"]),Uint32Array),h=Jn(await Is(e["grains-radius"]),Float32Array),u={t:s[0],count:n,box:r,view:o,numbers:a,values:l,ids:c,radius:h};if(n===0)return;this.grains.push(u),this.end=Math.max(this.end,u.t),this.grains.length>2&&this.grains.length*n*(3+a.length)>Y0&&(this.grains=this.grains.filter((m,p)=>p%2===0||p===this.grains.length-1),this.stale=!0);let f=this.run?.grains,d=this.stage?.grains;if(!(d&&!this.stale&&Od(f.box,r)&&a.length===f.numbers.length&&this.placesFor(u,d)))return this.renew(!d);let x=a.some((m,p)=>m.largest>f.numbers[p].largest);return f.times.push(u.t),d.add(this.grainValues(u,f)),a.forEach((m,p)=>f.numbers[p].shown=Math.max(f.numbers[p].shown,m.shown)),x?this.renewSoon():this.grown(!0)}placesFor({ids:t,radius:e,count:n},s){for(let r=0;r<n;++r){if(this.places.has(t[r]))continue;let o=this.places.size;if(o>=this.run.grains.count)return!1;this.places.set(t[r],o),s.radius[o]=e[r],s.geometry.attributes.radius.needsUpdate=!0}return!0}grainValues(t,e){let n=e.count,s=new Uint16Array(n*(3+e.numbers.length)),{ids:r,count:o}=t,a=Uint32Array.from(r,l=>this.places.get(l));s.fill(Wh,0,n);for(let l=0;l<3;++l){let c=Bd(t.box,e.box,l);for(let h=0;h<o;++h)s[l*n+a[h]]=c(t.values[l*o+h])}return e.numbers.forEach((l,c)=>{let h=Math.sqrt(t.numbers[c].largest/l.largest);for(let u=0;u<o;++u)s[(3+c)*n+a[u]]=Math.min(255,Math.round(h*t.values[(3+c)*o+u]))}),this.measureWay(s,e,n),s}measureWay(t,e,n){this.first||(this.first=t);let s=0;for(let r=0;r<n;++r){if(t[r]===Wh||this.first[r]===Wh)continue;let o=0;for(let a=0;a<3;++a)o+=(e.box.size[a]*(t[a*n+r]-this.first[a*n+r])/kd)**2;s=Math.max(s,o)}e.farthest=Math.max(e.farthest,Math.sqrt(s))}grainsSpec(){let t=this.grains;if(t.length===0)return null;this.places=new Map;for(let{ids:l}of t)for(let c of l)this.places.has(c)||this.places.set(c,this.places.size);let e=this.places.size,n=e+(e>t[0].count?Math.ceil(q0*e):0),s=new Float32Array(n);for(let l of t)l.ids.forEach((c,h)=>s[this.places.get(c)]=l.radius[h]);let r=(l,c)=>Math.max(...t.map(h=>h.numbers[c]?.[l]??0)),o=t.at(-1).numbers.map(({name:l,unit:c},h)=>({name:l,unit:c,largest:2*r("largest",h),shown:r("shown",h)})),a={count:n,times:t.map(l=>l.t),box:Fd(Ud(t.map(l=>l.box))),view:t[0].view,numbers:o,farthest:0};return this.first=null,Hn.set("grains-radius",s),t.forEach((l,c)=>Hn.set(`grains-${c}`,this.grainValues(l,a))),a}renewSoon(){if(this.grown(!0),this.over||performance.now()>=this.due)return this.renew();this.waitToRenew(this.due)}waitToRenew(t){this.waiting??=setTimeout(()=>{this.waiting=void 0,this.next(()=>this.renew())},t-performance.now())}async renew(t=!1){if(this.stale=!0,!this.history||this.rows<2)return;let e=performance.now(),n=t?this.first:this.due;if(e<n&&!this.over)return this.waitToRenew(n);if(clearTimeout(this.waiting),this.waiting=void 0,this.stale=!1,!this.meshes){this.meshes=new Map;for(let s=0;s<(this.head.meshes??[]).length;++s)this.meshes.set(`mesh-${s}`,await Fo(`mesh-${s}`,Float32Array))}Hn.clear();for(let[s,r]of this.meshes)Hn.set(s,r);this.run={...this.head,bodyNames:this.names??[],grains:this.grainsSpec(),bodies:this.bodiesSpec(),marks:this.marksSpec(),history:!0},this.stage=await this.rebuild(this.run,this.history,this.shown),this.due=performance.now()+Math.min(K0,J0*(performance.now()-e))}};var qa=class{constructor({start:t,end:e,marks:n}){Object.assign(this,{start:t,end:e,marks:n}),this.time=t,this.seconds=8,this.speed=1,this.playing=!1,this.live=!1,this.follows=!1,this.onLive=()=>{},this.onTime=()=>{},this.onPlaying=()=>{},this.onStopped=()=>{},this.drawn=[]}seek(t){this.time=Math.min(this.end,Math.max(this.start,t)),this.onTime(this.time)}grow(t){this.end=Math.max(this.end,t),this.live&&!this.playing?this.seek(this.end):this.onTime(this.time)}setLive(t){this.live!==t&&(this.live=t,this.onLive(t),t&&this.seek(this.end))}step(t){this.play(!1);let e=this.marks,n=1e-9*(this.end-this.start);t>0?this.seek(e.find(s=>s>this.time+n)??this.end):this.seek([...e].reverse().find(s=>s<this.time-n)??this.start)}play(t=!this.playing){this.setLive(!1),t!==this.playing&&(this.playing=t,t&&this.time>=this.end&&this.seek(this.start),this.onPlaying(t),this.last=null,this.drawn=[],t||this.onStopped(),t&&requestAnimationFrame(e=>this.tick(e)))}tick(t){if(this.playing){if(this.last!==null){let e=(this.end-this.start)/this.seconds*this.speed,n=this.time+e*(t-this.last)/1e3;if(this.seek(n),n>=this.end)return this.play(!1),this.follows&&this.setLive(!0);this.drawn.push(t),this.drawn.length>30&&this.drawn.shift()}this.last=t,requestAnimationFrame(e=>this.tick(e))}}rate(){let t=this.drawn.length;return t>5?1e3*(t-1)/(this.drawn[t-1]-this.drawn[0]):0}};var j0="uplot",Q0="u-hz",t_="u-vt",e_="u-title",n_="u-wrap",i_="u-under",s_="u-over",r_="u-axis",rr="u-off",o_="u-select",a_="u-cursor-x",l_="u-cursor-y",c_="u-cursor-pt",h_="u-legend",u_="u-live",f_="u-inline",d_="u-series",p_="u-marker",zd="u-label",m_="u-value",ko="width",zo="height";var Vd="bottom",Nr="left",Xh="right",lu="#000",Gd=lu+"0",qh="mousemove",Hd="mousedown",Yh="mouseup",Wd="mouseenter",Xd="mouseleave",qd="dblclick",g_="resize",__="scroll",Yd="change",Ka="dppxchange",cu="--",Vr=typeof window<"u",jh=Vr?document:null,Fr=Vr?window:null,x_=Vr?navigator:null,Te,Ya;function Qh(){let i=devicePixelRatio;Te!=i&&(Te=i,Ya&&eu(Yd,Ya,Qh),Ya=matchMedia(`(min-resolution: ${Te-.001}dppx) and (max-resolution: ${Te+.001}dppx)`),or(Yd,Ya,Qh),Fr.dispatchEvent(new CustomEvent(Ka)))}function ai(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function tu(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Ye(i,t,e){i.style[t]=e+"px"}function Ai(i,t,e,n){let s=jh.createElement(i);return t!=null&&ai(s,t),e?.insertBefore(s,n),s}function vi(i,t){return Ai("div",i,t)}var $d=new WeakMap;function qi(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=$d.get(i);r!=o&&(i.style.transform=r,$d.set(i,r),t<0||e<0||t>n||e>s?ai(i,rr):tu(i,rr))}var Zd=new WeakMap;function Jd(i,t,e){let n=t+e,s=Zd.get(i);n!=s&&(Zd.set(i,n),i.style.background=t,i.style.borderColor=e)}var Kd=new WeakMap;function jd(i,t,e,n){let s=t+""+e,r=Kd.get(i);s!=r&&(Kd.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var hu={passive:!0},y_={...hu,capture:!0};function or(i,t,e,n){t.addEventListener(i,e,n?y_:hu)}function eu(i,t,e,n){t.removeEventListener(i,e,hu)}Vr&&Qh();function Ci(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:li((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function Tp(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var Ap=i=>i!=null,Cp=i=>i!=null&&i>0,tl=Tp(Ap),v_=Tp(Cp);function M_(i,t,e,n=0,s=!1){let r=s?v_:tl,o=s?Cp:Ap;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??ke,l??-ke]}function el(i,t,e,n){let s=ep(i),r=ep(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?ls:Rp,a=s==1?li:Mi,l=r==1?Mi:li,c=a(o(vn(i))),h=l(o(vn(t))),u=Or(e,c),f=Or(e,h);return e==10&&(c<0&&(u=ze(u,-c)),h<0&&(f=ze(f,-h))),n||e==2?(i=u*s,t=f*r):(i=Dp(i,u),t=nl(t,f)),[i,t]}function uu(i,t,e,n){let s=el(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var fu=.1,Qd={mode:3,pad:fu},Go={pad:0,soft:null,mode:0},b_={min:Go,max:Go};function ja(i,t,e,n){return il(e)?tp(i,t,e):(Go.pad=e,Go.soft=n?0:null,Go.mode=n?3:0,tp(i,t,b_))}function we(i,t){return i??t}function S_(i,t,e){for(t=we(t,0),e=we(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function tp(i,t,e){let n=e.min,s=e.max,r=we(n.pad,0),o=we(s.pad,0),a=we(n.hard,-ke),l=we(s.hard,ke),c=we(n.soft,ke),h=we(s.soft,-ke),u=we(n.mode,0),f=we(s.mode,0),d=t-i,g=ls(d),x=Wn(vn(i),vn(t)),m=ls(x),p=vn(m-g);(d<1e-24||p>10)&&(d=0,(i==0||t==0)&&(d=1e-24,u==2&&c!=ke&&(r=0),f==2&&h!=-ke&&(o=0)));let v=d||x||1e3,A=ls(v),M=Or(10,li(A)),C=v*(d==0?i==0?.1:1:r),S=ze(Dp(i-C,M/10),24),_=i>=c&&(u==1||u==3&&S<=c||u==2&&S>=c)?c:ke,E=Wn(a,S<_&&i>=_?_:Ri(_,S)),U=v*(d==0?t==0?.1:1:o),D=ze(nl(t+U,M/10),24),L=t<=h&&(f==1||f==3&&D>=h||f==2&&D<=h)?h:-ke,B=Ri(l,D>L&&t<=L?L:Wn(L,D));return E==B&&E==0&&(B=100),[E,B]}var w_=new Intl.NumberFormat(Vr?x_.language:"en-US"),du=i=>w_.format(i),ci=Math,Ja=ci.PI,vn=ci.abs,li=ci.floor,yn=ci.round,Mi=ci.ceil,Ri=ci.min,Wn=ci.max,Or=ci.pow,ep=ci.sign,ls=ci.log10,Rp=ci.log2,E_=(i,t=1)=>ci.sinh(i)*t,$h=(i,t=1)=>ci.asinh(i/t),ke=1/0;function np(i){return(ls((i^i>>31)-(i>>31))|0)+1}function nu(i,t,e){return Ri(Wn(i,t),e)}function Pp(i){return typeof i=="function"}function xe(i){return Pp(i)?i:()=>i}var T_=()=>{},Ip=i=>i,Lp=(i,t)=>t,A_=i=>null,ip=i=>!0,sp=(i,t)=>i==t,C_=/\.\d*?(?=9{6,}|0{6,})/gm,ar=i=>{if(Up(i)||Ds.has(i))return i;let t=`${i}`,e=t.match(C_);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${ar(s)}e${r}`}return ze(i,n)};function ir(i,t){return ar(ze(ar(i/t))*t)}function nl(i,t){return ar(Mi(ar(i/t))*t)}function Dp(i,t){return ar(li(ar(i/t))*t)}function ze(i,t=0){if(Up(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return yn(n)/e}var Ds=new Map;function Np(i){return((""+i).split(".")[1]||"").length}function Wo(i,t,e,n){let s=[],r=n.map(Np);for(let o=t;o<e;o++){let a=vn(o),l=ze(Or(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?h:ze(h,u);s.push(f),Ds.set(f,u)}}return s}var Ho={},pu=[],Br=[null,null],Ls=Array.isArray,Up=Number.isInteger,R_=i=>i===void 0;function rp(i){return typeof i=="string"}function il(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function P_(i){return i!=null&&typeof i=="object"}var I_=Object.getPrototypeOf(Uint8Array),Fp="__proto__";function kr(i,t=il){let e;if(Ls(i)){let n=i.find(s=>s!=null);if(Ls(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=kr(i[s],t)}else e=i.slice()}else if(i instanceof I_)e=i.slice();else if(t(i)){e={};for(let n in i)n!=Fp&&(e[n]=kr(i[n],t))}else e=i;return e}function pn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=Fp&&(il(i[s])?pn(i[s],kr(n[s])):i[s]=kr(n[s]))}return i}var L_=0,D_=1,N_=2;function U_(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function F_(i,t){if(k_(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return z_(o[0])||(o=B_(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),f=t?t[o][c]:D_,d=[];for(let g=0;g<h.length;g++){let x=h[g],m=r.get(l[g]);x===null?f!=L_&&(u[m]=x,f==N_&&d.push(m)):u[m]=x}U_(u,d,s),n.push(u)}}return n}var O_=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function B_(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function k_(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function z_(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Wn(1,li((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Op=["January","February","March","April","May","June","July","August","September","October","November","December"],Bp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function kp(i){return i.slice(0,3)}var V_=Bp.map(kp),G_=Op.map(kp),H_={MMMM:Op,MMM:G_,WWWW:Bp,WWW:V_};function Bo(i){return(i<10?"0":"")+i}function W_(i){return(i<10?"00":i<100?"0":"")+i}var X_={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Bo(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Bo(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Bo(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Bo(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Bo(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>W_(i.getMilliseconds())};function mu(i,t){t=t||H_;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?X_[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var q_=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Y_(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==q_?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var zp=i=>i%1==0,Qa=[1,2,2.5,5],$_=Wo(10,-32,0,Qa),Vp=Wo(10,0,32,Qa),Z_=Vp.filter(zp),sr=$_.concat(Vp),gu=`
`,Gp="{YYYY}",op=gu+Gp,Hp="{M}/{D}",Vo=gu+Hp,$a=Vo+"/{YY}",Wp="{aa}",J_="{h}:{mm}",Ur=J_+Wp,ap=gu+Ur,lp=":{ss}",Ce=null;function Xp(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?Wo(10,0,3,Qa).filter(zp):Wo(10,-3,0,Qa)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Gp,Ce,Ce,Ce,Ce,Ce,Ce,1],[s*28,"{MMM}",op,Ce,Ce,Ce,Ce,Ce,1],[s,Hp,op,Ce,Ce,Ce,Ce,Ce,1],[n,"{h}"+Wp,$a,Ce,Vo,Ce,Ce,Ce,1],[e,Ur,$a,Ce,Vo,Ce,Ce,Ce,1],[t,lp,$a+" "+Ur,Ce,Vo+" "+Ur,Ce,ap,Ce,1],[i,lp+".{fff}",$a+" "+Ur,Ce,Vo+" "+Ur,Ce,ap,Ce,1]];function h(u){return(f,d,g,x,m,p)=>{let v=[],A=m>=o,M=m>=r&&m<o,C=u(g),S=ze(C*i,3),_=Zh(C.getFullYear(),A?0:C.getMonth(),M||A?1:C.getDate()),E=ze(_*i,3);if(M||A){let U=M?m/r:0,D=A?m/o:0,L=S==E?S:ze(Zh(_.getFullYear()+D,_.getMonth()+U,1)*i,3),B=new Date(yn(L/i)),F=B.getFullYear(),I=B.getMonth();for(let z=0;L<=x;z++){let X=Zh(F+D*z,I+U*z,1),V=X-u(ze(X*i,3));L=ze((+X+V)*i,3),L<=x&&v.push(L)}}else{let U=m>=s?s:m,D=li(g)-li(S),L=E+D+nl(S-E,U);v.push(L);let B=u(L),F=B.getHours()+B.getMinutes()/e+B.getSeconds()/n,I=m/n,z=f.axes[d]._space,X=p/z;for(;L=ze(L+m,i==1?0:3),!(L>x);)if(I>1){let V=li(ze(F+I,6))%24,j=u(L).getHours()-V;j>1&&(j=-1),L-=j*n,F=(F+I)%24;let tt=v[v.length-1];ze((L-tt)/m,3)*X>=.7&&v.push(L)}else v.push(L)}return v}}return[l,c,h]}var[K_,j_,Q_]=Xp(1),[tx,ex,nx]=Xp(.001);Wo(2,-53,53,[1]);function cp(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function hp(i,t){return(e,n,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,h,u,f,d;return n.map(g=>{let x=i(g),m=x.getFullYear(),p=x.getMonth(),v=x.getDate(),A=x.getHours(),M=x.getMinutes(),C=x.getSeconds(),S=m!=l&&a[2]||p!=c&&a[3]||v!=h&&a[4]||A!=u&&a[5]||M!=f&&a[6]||C!=d&&a[7]||a[1];return l=m,c=p,h=v,u=A,f=M,d=C,S(x)})}}function ix(i,t){let e=mu(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function Zh(i,t,e){return new Date(i,t,e)}function up(i,t){return t(i)}var sx="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function fp(i,t){return(e,n,s,r)=>r==null?cu:t(i(n))}function rx(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function ox(i,t){return i.series[t].fill(i,t)}var ax={show:!0,live:!0,isolate:!1,mount:T_,markers:{show:!0,width:2,stroke:rx,fill:ox,dash:"solid"},idx:null,idxs:null,values:[]};function lx(i,t){let e=i.cursor.points,n=vi(),s=e.size(i,t);Ye(n,ko,s),Ye(n,zo,s);let r=s/-2;Ye(n,"marginLeft",r),Ye(n,"marginTop",r);let o=e.width(i,t,s);return o&&Ye(n,"borderWidth",o),n}function cx(i,t){let e=i.series[t].points;return e._fill||e._stroke}function hx(i,t){let e=i.series[t].points;return e._stroke||e._fill}function ux(i,t){return i.series[t].points.size}var Jh=[0,0];function fx(i,t,e){return Jh[0]=t,Jh[1]=e,Jh}function Za(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function Kh(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var dx={show:!0,x:!0,y:!0,lock:!1,move:fx,points:{one:!1,show:lx,size:ux,width:0,stroke:hx,fill:cx},bind:{mousedown:Za,mouseup:Za,click:Za,dblclick:Za,mousemove:Kh,mouseleave:Kh,mouseenter:Kh},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},qp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},_u=pn({},qp,{filter:Lp}),Yp=pn({},_u,{size:10}),$p=pn({},qp,{show:!1}),xu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Zp="bold "+xu,Jp=1.5,dp={show:!0,scale:"x",stroke:lu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Zp,side:2,grid:_u,ticks:Yp,border:$p,font:xu,lineGap:Jp,rotate:0},px="Value",mx="Time",pp={show:!0,scale:"x",auto:!1,sorted:1,min:ke,max:-ke,idxs:[]};function gx(i,t,e,n,s){return t.map(r=>r==null?"":du(r))}function _x(i,t,e,n,s,r,o){let a=[],l=Ds.get(s)||0;e=o?e:ze(nl(e,s),l);for(let c=e;c<=n;c=ze(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function iu(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?ls:Rp,h=li(c(e));s=Or(l,h),l==10&&(s=sr[Ci(s,sr)]);let u=e,f=s*l;l==10&&(f=sr[Ci(f,sr)]);do a.push(u),u=u+s,l==10&&!Ds.has(u)&&(u=ze(u,Ds.get(s))),u>=f&&(s=u,f=s*l,l==10&&(f=sr[Ci(f,sr)]));while(u<=n);return a}function xx(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?iu(i,t,Wn(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?iu(i,t,Wn(l,-n),-e,s):[l]).reverse().map(f=>-f).concat(h,c)}var Kp=/./,yx=/[12357]/,vx=/[125]/,mp=/1/,su=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Mx(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?Kp:l(7,o)-h>=c?yx:l(5,o)-h>=c?vx:mp;if(u==mp){let f=vn(l(1,o)-h);if(f<c)return su(t.slice().reverse(),a.distr,u,Mi(c/f)).reverse()}return su(t,a.distr,u,1)}function bx(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=vn(l(1,o)-l(2,o));return c<a?su(t.slice().reverse(),3,Kp,Mi(a/c)).reverse():t}function Sx(i,t,e,n){return n==null?cu:t==null?"":du(t)}var gp={show:!0,scale:"y",stroke:lu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Zp,side:3,grid:_u,ticks:Yp,border:$p,font:xu,lineGap:Jp,rotate:0};function wx(i,t){let e=3+(i||1)*2;return ze(e*t,3)}function Ex(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=vn(o-r),l=i.series[t],c=a/(l.points.space*Te);return n[1]-n[0]<=c}var _p={scale:null,auto:!0,sorted:0,min:ke,max:-ke},jp=(i,t,e,n,s)=>s,xp={show:!0,auto:!0,sorted:0,gaps:jp,alpha:1,facets:[pn({},_p,{scale:"x"}),pn({},_p,{scale:"y"})]},yp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:jp,alpha:1,points:{show:Ex,filter:null},values:null,min:ke,max:-ke,idxs:[],path:null,clip:null};function Tx(i,t,e,n,s){return e/10}var Qp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Ax=pn({},Qp,{time:!1,ori:1}),vp={};function tm(i,t){let e=vp[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(vp[i]=e)),e}var zr=1,ru=2;function lr(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,g=a.width,x=a.height,m=i.valToPosH,p=i.valToPosV;return h.ori==0?e(s,l,c,h,u,m,p,f,d,g,x,rl,Gr,al,nm,sm):e(s,l,c,h,u,p,m,d,f,x,g,ol,Hr,Mu,im,rm)}function yu(i,t){let e=0,n=0,s=we(i.bands,pu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function Cx(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function cs(i,t,e,n,s,r){return lr(i,t,(o,a,l,c,h,u,f,d,g,x,m)=>{let p=o.pxRound,v=c.dir*(c.ori==0?1:-1),A=c.ori==0?Gr:Hr,M,C;v==1?(M=e,C=n):(M=n,C=e);let S=p(u(a[M],c,x,d)),_=p(f(l[M],h,m,g)),E=p(u(a[C],c,x,d)),U=p(f(r==1?h.max:h.min,h,m,g)),D=new Path2D(s);return A(D,E,U),A(D,S,U),A(D,S,_),D})}function sl(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?al:Mu,l=e;for(let u=0;u<i.length;u++){let f=i[u];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+r),l=f[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function Rx(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function vu(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,f=c;if(s==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=r(i[u]),g=f==u?d:r(i[f]),x=u-s;d=o<=0&&x>=0&&x<l?r(i[x]):d;let p=f+s;g=o>=0&&p>=0&&p<l?r(i[p]):g,g>=d&&a.push([d,g])}return a}function Mp(i){return i==0?Ip:i==1?yn:t=>ir(t,i)}function em(i){let t=i==0?rl:ol,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Ri(c,a/2,l/2),h=Ri(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var rl=(i,t,e)=>{i.moveTo(t,e)},ol=(i,t,e)=>{i.moveTo(e,t)},Gr=(i,t,e)=>{i.lineTo(t,e)},Hr=(i,t,e)=>{i.lineTo(e,t)},al=em(0),Mu=em(1),nm=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},im=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},sm=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},rm=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function om(i){return(t,e,n,s,r)=>lr(t,e,(o,a,l,c,h,u,f,d,g,x,m)=>{let{pxRound:p,points:v}=o,A,M;c.ori==0?(A=rl,M=nm):(A=ol,M=im);let C=ze(v.width*Te,3),S=(v.size-v.width)/2*Te,_=ze(S*2,3),E=new Path2D,U=new Path2D,{left:D,top:L,width:B,height:F}=t.bbox;al(U,D-_,L-_,B+_*2,F+_*2);let I=z=>{if(l[z]!=null){let X=p(u(a[z],c,x,d)),V=p(f(l[z],h,m,g));A(E,X+S,V),M(E,X,V,S,0,Ja*2)}};if(r)r.forEach(I);else for(let z=n;z<=s;z++)I(z);return{stroke:C>0?E:null,fill:E,clip:U,flags:zr|ru}})}function am(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var Px=am(Gr),Ix=am(Hr);function lm(i){let t=we(i?.alignGaps,0);return(e,n,s,r)=>lr(e,n,(o,a,l,c,h,u,f,d,g,x,m)=>{[s,r]=tl(l,s,r);let p=o.pxRound,v=F=>p(u(F,c,x,d)),A=F=>p(f(F,h,m,g)),M,C;c.ori==0?(M=Gr,C=Px):(M=Hr,C=Ix);let S=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:zr},E=_.stroke,U=!1;if(r-s>=x*4){let F=it=>e.posToVal(it,c.key,!0),I=null,z=null,X,V,ot,q=v(a[S==1?s:r]),j=v(a[s]),tt=v(a[r]),lt=F(S==1?j+1:tt-1);for(let it=S==1?s:r;it>=s&&it<=r;it+=S){let Z=a[it],dt=(S==1?Z<lt:Z>lt)?q:v(Z),Mt=l[it];dt==q?Mt!=null?(V=Mt,I==null?(M(E,dt,A(V)),X=I=z=V):V<I?I=V:V>z&&(z=V)):Mt===null&&(U=!0):(I!=null&&C(E,q,A(I),A(z),A(X),A(V)),Mt!=null?(V=Mt,M(E,dt,A(V)),I=z=X=V):(I=z=null,Mt===null&&(U=!0)),q=dt,lt=F(q+S))}I!=null&&I!=z&&ot!=q&&C(E,q,A(I),A(z),A(X),A(V))}else for(let F=S==1?s:r;F>=s&&F<=r;F+=S){let I=l[F];I===null?U=!0:I!=null&&M(E,v(a[F]),A(I))}let[L,B]=yu(e,n);if(o.fill!=null||L!=0){let F=_.fill=new Path2D(E),I=o.fillTo(e,n,o.min,o.max,L),z=A(I),X=v(a[s]),V=v(a[r]);S==-1&&([V,X]=[X,V]),M(F,V,z),M(F,X,z)}if(!o.spanGaps){let F=[];U&&F.push(...vu(a,l,s,r,S,v,t)),_.gaps=F=o.gaps(e,n,s,r,F),_.clip=sl(F,c.ori,d,g,x,m)}return B!=0&&(_.band=B==2?[cs(e,n,s,r,E,-1),cs(e,n,s,r,E,1)]:cs(e,n,s,r,E,B)),_})}function Lx(i){let t=we(i.align,1),e=we(i.ascDesc,!1),n=we(i.alignGaps,0),s=we(i.extend,!1);return(r,o,a,l)=>lr(r,o,(c,h,u,f,d,g,x,m,p,v,A)=>{[a,l]=tl(u,a,l);let M=c.pxRound,{left:C,width:S}=r.bbox,_=j=>M(g(j,f,v,m)),E=j=>M(x(j,d,A,p)),U=f.ori==0?Gr:Hr,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:zr},L=D.stroke,B=f.dir*(f.ori==0?1:-1),F=E(u[B==1?a:l]),I=_(h[B==1?a:l]),z=I,X=I;s&&t==-1&&(X=C,U(L,X,F)),U(L,I,F);for(let j=B==1?a:l;j>=a&&j<=l;j+=B){let tt=u[j];if(tt==null)continue;let lt=_(h[j]),it=E(tt);t==1?U(L,lt,F):U(L,z,it),U(L,lt,it),F=it,z=lt}let V=z;s&&t==1&&(V=C+S,U(L,V,F));let[ot,q]=yu(r,o);if(c.fill!=null||ot!=0){let j=D.fill=new Path2D(L),tt=c.fillTo(r,o,c.min,c.max,ot),lt=E(tt);U(j,V,lt),U(j,X,lt)}if(!c.spanGaps){let j=[];j.push(...vu(h,u,a,l,B,_,n));let tt=c.width*Te/2,lt=e||t==1?tt:-tt,it=e||t==-1?-tt:tt;j.forEach(Z=>{Z[0]+=lt,Z[1]+=it}),D.gaps=j=c.gaps(r,o,a,l,j),D.clip=sl(j,f.ori,m,p,v,A)}return q!=0&&(D.band=q==2?[cs(r,o,a,l,L,-1),cs(r,o,a,l,L,1)]:cs(r,o,a,l,L,q)),D})}function bp(i,t,e,n,s,r,o=ke){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=vn(i[l]-i[a]);h<c&&(c=h,o=vn(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function Dx(i){i=i||Ho;let t=we(i.size,[.6,ke,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=xe(s),o=1-t[0],a=we(t[1],ke),l=we(t[2],1),c=we(i.disp,Ho),h=we(i.each,d=>{}),{fill:u,stroke:f}=c;return(d,g,x,m)=>lr(d,g,(p,v,A,M,C,S,_,E,U,D,L)=>{let B=p.pxRound,F=e,I=n*Te,z=a*Te,X=l*Te,V,ot;M.ori==0?[V,ot]=r(d,g):[ot,V]=r(d,g);let q=M.dir*(M.ori==0?1:-1),j=M.ori==0?al:Mu,tt=M.ori==0?h:(Ct,$t,se,St,Be,Vt,qt)=>{h(Ct,$t,se,Be,St,qt,Vt)},lt=we(d.bands,pu).find(Ct=>Ct.series[0]==g),it=lt!=null?lt.dir:0,Z=p.fillTo(d,g,p.min,p.max,it),ft=B(_(Z,C,L,U)),dt,Mt,gt,kt=D,Wt=B(p.width*Te),Nt=!1,ee=null,jt=null,Xt=null,Ne=null;u!=null&&(Wt==0||f!=null)&&(Nt=!0,ee=u.values(d,g,x,m),jt=new Map,new Set(ee).forEach(Ct=>{Ct!=null&&jt.set(Ct,new Path2D)}),Wt>0&&(Xt=f.values(d,g,x,m),Ne=new Map,new Set(Xt).forEach(Ct=>{Ct!=null&&Ne.set(Ct,new Path2D)})));let{x0:ae,size:Ue}=c;if(ae!=null&&Ue!=null){F=1,v=ae.values(d,g,x,m),ae.unit==2&&(v=v.map(se=>d.posToVal(E+se*D,M.key,!0)));let Ct=Ue.values(d,g,x,m);Ue.unit==2?Mt=Ct[0]*D:Mt=S(Ct[0],M,D,E)-S(0,M,D,E),kt=bp(v,A,S,M,D,E,kt),gt=kt-Mt+I}else kt=bp(v,A,S,M,D,E,kt),gt=kt*o+I,Mt=kt-gt;gt<1&&(gt=0),Wt>=Mt/2&&(Wt=0),gt<5&&(B=Ip);let ge=gt>0,Ke=kt-gt-(ge?Wt:0);Mt=B(nu(Ke,X,z)),dt=(F==0?Mt/2:F==q?0:Mt)-F*q*((F==0?I/2:0)+(ge?Wt/2:0));let be={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},_n=Nt?null:new Path2D,en=null;if(lt!=null)en=d.data[lt.series[1]];else{let{y0:Ct,y1:$t}=c;Ct!=null&&$t!=null&&(A=$t.values(d,g,x,m),en=Ct.values(d,g,x,m))}let cn=V*Mt,k=ot*Mt;for(let Ct=q==1?x:m;Ct>=x&&Ct<=m;Ct+=q){let $t=A[Ct];if($t==null)continue;if(en!=null){let Y=en[Ct]??0;if($t-Y==0)continue;ft=_(Y,C,L,U)}let se=M.distr!=2||c!=null?v[Ct]:Ct,St=S(se,M,D,E),Be=_(we($t,Z),C,L,U),Vt=B(St-dt),qt=B(Wn(Be,ft)),R=B(Ri(Be,ft)),b=qt-R;if($t!=null){let Y=$t<0?k:cn,ut=$t<0?cn:k;Nt?(Wt>0&&Xt[Ct]!=null&&j(Ne.get(Xt[Ct]),Vt,R+li(Wt/2),Mt,Wn(0,b-Wt),Y,ut),ee[Ct]!=null&&j(jt.get(ee[Ct]),Vt,R+li(Wt/2),Mt,Wn(0,b-Wt),Y,ut)):j(_n,Vt,R+li(Wt/2),Mt,Wn(0,b-Wt),Y,ut),tt(d,g,Ct,Vt-Wt/2,R,Mt+Wt,b)}}return Wt>0?be.stroke=Nt?Ne:_n:Nt||(be._fill=p.width==0?p._fill:p._stroke??p._fill,be.width=0),be.fill=Nt?jt:_n,be})}function Nx(i,t){let e=we(t?.alignGaps,0);return(n,s,r,o)=>lr(n,s,(a,l,c,h,u,f,d,g,x,m,p)=>{[r,o]=tl(c,r,o);let v=a.pxRound,A=V=>v(f(V,h,m,g)),M=V=>v(d(V,u,p,x)),C,S,_;h.ori==0?(C=rl,_=Gr,S=sm):(C=ol,_=Hr,S=rm);let E=h.dir*(h.ori==0?1:-1),U=A(l[E==1?r:o]),D=U,L=[],B=[];for(let V=E==1?r:o;V>=r&&V<=o;V+=E)if(c[V]!=null){let q=l[V],j=A(q);L.push(D=j),B.push(M(c[V]))}let F={stroke:i(L,B,C,_,S,v),fill:null,clip:null,band:null,gaps:null,flags:zr},I=F.stroke,[z,X]=yu(n,s);if(a.fill!=null||z!=0){let V=F.fill=new Path2D(I),ot=a.fillTo(n,s,a.min,a.max,z),q=M(ot);_(V,D,q),_(V,U,q)}if(!a.spanGaps){let V=[];V.push(...vu(l,c,r,o,E,A,e)),F.gaps=V=a.gaps(n,s,r,o,V),F.clip=sl(V,h.ori,g,x,m,p)}return X!=0&&(F.band=X==2?[cs(n,s,r,o,I,-1),cs(n,s,r,o,I,1)]:cs(n,s,r,o,I,X)),F})}function Ux(i){return Nx(Fx,i)}function Fx(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let f=0;f<o-1;f++)h[f]=t[f+1]-t[f],u[f]=i[f+1]-i[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+u[f]/3,t[f]+l[f]*u[f]/3,i[f+1]-u[f]/3,t[f+1]-l[f+1]*u[f]/3,i[f+1],t[f+1])}return a}var ou=new Set;function Sp(){for(let i of ou)i.syncRect(!0)}Vr&&(or(g_,Fr,Sp),or(__,Fr,Sp,!0),or(Ka,Fr,()=>{Ln.pxRatio=Te}));var Ox=lm(),Bx=om();function wp(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>au(r,o,t,e))}function kx(i,t){return i.map((e,n)=>n==0?{}:pn({},t,e))}function au(i,t,e,n){return pn({},t==0?e:n,i)}function cm(i,t,e){return t==null?Br:[t,e]}var zx=cm;function Vx(i,t,e){return t==null?Br:ja(t,e,fu,!0)}function hm(i,t,e,n){return t==null?Br:el(t,e,i.scales[n].log,!1)}var Gx=hm;function um(i,t,e,n){return t==null?Br:uu(t,e,i.scales[n].log,!1)}var Hx=um;function Wx(i,t,e,n,s){let r=Wn(np(i),np(t)),o=t-i,a=Ci(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?Ds.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Ep(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=yn((e=+s)*Te))+"px"),[i,t,e]}function Xx(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=ze(t[2]*Te,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Ln(i,t,e){let n={mode:we(i.mode,1)},s=n.mode;function r(y,w,P,N){let H=w.valToPct(y);return N+P*(w.dir==-1?1-H:H)}function o(y,w,P,N){let H=w.valToPct(y);return N+P*(w.dir==-1?H:1-H)}function a(y,w,P,N){return w.ori==0?r(y,w,P,N):o(y,w,P,N)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=vi(j0);if(i.id!=null&&(c.id=i.id),ai(c,i.class),i.title){let y=vi(e_,c);y.textContent=i.title}let h=Ai("canvas"),u=n.ctx=h.getContext("2d"),f=vi(n_,c);or("click",f,y=>{y.target===g&&(We!=Rr||Ze!=Pr)&&In.click(n,y)},!0);let d=n.under=vi(i_,f);f.appendChild(h);let g=n.over=vi(s_,f);i=kr(i);let x=+we(i.pxAlign,1),m=Mp(x);(i.plugins||[]).forEach(y=>{y.opts&&(i=y.opts(n,i)||i)});let p=i.ms||.001,v=n.series=s==1?wp(i.series||[],pp,yp,!1):kx(i.series||[null],xp),A=n.axes=wp(i.axes||[],dp,gp,!0),M=n.scales={},C=n.bands=i.bands||[];C.forEach(y=>{y.fill=xe(y.fill||null),y.dir=we(y.dir,-1)});let S=s==2?v[1].facets[0].scale:v[0].scale,_={axes:is,series:fe},E=(i.drawOrder||["axes","series"]).map(y=>_[y]);function U(y){let w=y.distr==3?P=>ls(P>0?P:y.clamp(n,P,y.min,y.max,y.key)):y.distr==4?P=>$h(P,y.asinh):y.distr==100?P=>y.fwd(P):P=>P;return P=>{let N=w(P),{_min:H,_max:K}=y,ct=K-H;return(N-H)/ct}}function D(y){let w=M[y];if(w==null){let P=(i.scales||Ho)[y]||Ho;if(P.from!=null){D(P.from);let N=pn({},M[P.from],P,{key:y});N.valToPct=U(N),M[y]=N}else{w=M[y]=pn({},y==S?Qp:Ax,P),w.key=y;let N=w.time,H=w.range,K=Ls(H);if((y!=S||s==2&&!N)&&(K&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?Qd:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?Qd:{mode:1,hard:H[1],soft:H[1]}},K=!1),!K&&il(H))){let ct=H;H=(pt,vt,Lt)=>vt==null?Br:ja(vt,Lt,ct)}w.range=xe(H||(N?zx:y==S?w.distr==3?Gx:w.distr==4?Hx:cm:w.distr==3?hm:w.distr==4?um:Vx)),w.auto=xe(K?!1:w.auto),w.clamp=xe(w.clamp||Tx),w._min=w._max=null,w.valToPct=U(w)}}}D("x"),D("y"),s==1&&v.forEach(y=>{D(y.scale)}),A.forEach(y=>{D(y.scale)});for(let y in i.scales)D(y);let L=M[S],B=L.distr,F,I;L.ori==0?(ai(c,Q0),F=r,I=o):(ai(c,t_),F=o,I=r);let z={};for(let y in M){let w=M[y];(w.min!=null||w.max!=null)&&(z[y]={min:w.min,max:w.max},w.min=w.max=null)}let X=i.tzDate||(y=>new Date(yn(y/p))),V=i.fmtDate||mu,ot=p==1?Q_(X):nx(X),q=hp(X,cp(p==1?j_:ex,V)),j=fp(X,up(sx,V)),tt=[],lt=n.legend=pn({},ax,i.legend),it=n.cursor=pn({},dx,{drag:{y:s==2}},i.cursor),Z=lt.show,ft=it.show,dt=lt.markers;lt.idxs=tt,dt.width=xe(dt.width),dt.dash=xe(dt.dash),dt.stroke=xe(dt.stroke),dt.fill=xe(dt.fill);let Mt,gt,kt,Wt=[],Nt=[],ee,jt=!1,Xt={};if(lt.live){let y=v[1]?v[1].values:null;jt=y!=null,ee=jt?y(n,1,0):{_:0};for(let w in ee)Xt[w]=cu}if(Z)if(Mt=Ai("table",h_,c),kt=Ai("tbody",null,Mt),lt.mount(n,Mt),jt){gt=Ai("thead",null,Mt,kt);let y=Ai("tr",null,gt);Ai("th",null,y);for(var Ne in ee)Ai("th",zd,y).textContent=Ne}else ai(Mt,f_),lt.live&&ai(Mt,u_);let ae={show:!0},Ue={show:!1};function ge(y,w){if(w==0&&(jt||!lt.live||s==2))return Br;let P=[],N=Ai("tr",d_,kt,kt.childNodes[w]);ai(N,y.class),y.show||ai(N,rr);let H=Ai("th",null,N);if(dt.show){let pt=vi(p_,H);if(w>0){let vt=dt.width(n,w);vt&&(pt.style.border=vt+"px "+dt.dash(n,w)+" "+dt.stroke(n,w)),pt.style.background=dt.fill(n,w)}}let K=vi(zd,H);y.label instanceof HTMLElement?K.appendChild(y.label):K.textContent=y.label,w>0&&(dt.show||(K.style.color=y.width>0?dt.stroke(n,w):dt.fill(n,w)),be("click",H,pt=>{if(it._lock)return;Jt(pt);let vt=v.indexOf(y);if((pt.ctrlKey||pt.metaKey)!=lt.isolate){let Lt=v.some((Dt,Ft)=>Ft>0&&Ft!=vt&&Dt.show);v.forEach((Dt,Ft)=>{Ft>0&&Vi(Ft,Lt?Ft==vt?ae:Ue:ae,!0,dn.setSeries)})}else Vi(vt,{show:!y.show},!0,dn.setSeries)},!1),Kt&&be(Wd,H,pt=>{it._lock||(Jt(pt),Vi(v.indexOf(y),Lr,!0,dn.setSeries))},!1));for(var ct in ee){let pt=Ai("td",m_,N);pt.textContent="--",P.push(pt)}return[N,P]}let Ke=new Map;function be(y,w,P,N=!0){let H=Ke.get(w)||{},K=it.bind[y](n,w,P,N);K&&(or(y,w,H[y]=K),Ke.set(w,H))}function _n(y,w,P){let N=Ke.get(w)||{};for(let H in N)(y==null||H==y)&&(eu(H,w,N[H]),delete N[H]);y==null&&Ke.delete(w)}let en=0,cn=0,k=0,Ct=0,$t=0,se=0,St=$t,Be=se,Vt=k,qt=Ct,R=0,b=0,Y=0,ut=0;n.bbox={};let at=!1,xt=!1,yt=!1,et=!1,st=!1,mt=!1;function O(y,w,P){(P||y!=n.width||w!=n.height)&&rt(y,w),le(!1),yt=!0,xt=!0,Nn()}function rt(y,w){n.width=en=k=y,n.height=cn=Ct=w,$t=se=0,bt(),Gt();let P=n.bbox;R=P.left=ir($t*Te,.5),b=P.top=ir(se*Te,.5),Y=P.width=ir(k*Te,.5),ut=P.height=ir(Ct*Te,.5)}let nt=3;function wt(){let y=!1,w=0;for(;!y;){w++;let P=Tr(w),N=zi(w);y=w==nt||P&&N,y||(rt(n.width,n.height),xt=!0)}}function _t({width:y,height:w}){O(y,w)}n.setSize=_t;function bt(){let y=!1,w=!1,P=!1,N=!1;A.forEach((H,K)=>{if(H.show&&H._show){let{side:ct,_size:pt}=H,vt=ct%2,Lt=H.label!=null?H.labelSize:0,Dt=pt+Lt;Dt>0&&(vt?(k-=Dt,ct==3?($t+=Dt,N=!0):P=!0):(Ct-=Dt,ct==0?(se+=Dt,y=!0):w=!0))}}),Bi[0]=y,Bi[1]=P,Bi[2]=w,Bi[3]=N,k-=wi[1]+wi[3],$t+=wi[3],Ct-=wi[2]+wi[0],se+=wi[0]}function Gt(){let y=$t+k,w=se+Ct,P=$t,N=se;function H(K,ct){switch(K){case 1:return y+=ct,y-ct;case 2:return w+=ct,w-ct;case 3:return P-=ct,P+ct;case 0:return N-=ct,N+ct}}A.forEach((K,ct)=>{if(K.show&&K._show){let pt=K.side;K._pos=H(pt,K._size),K.label!=null&&(K._lpos=H(pt,K.labelSize))}})}if(it.dataIdx==null){let y=it.hover,w=y.skip=new Set(y.skip??[]);w.add(void 0);let P=y.prox=xe(y.prox),N=y.bias??=0;it.dataIdx=(H,K,ct,pt)=>{if(K==0)return ct;let vt=ct,Lt=P(H,K,ct,pt)??ke,Dt=Lt>=0&&Lt<ke,Ft=L.ori==0?k:Ct,ie=it.left,Ee=t[0],Se=t[K];if(w.has(Se[ct])){vt=null;let me=null,Zt=null,Ht;if(N==0||N==-1)for(Ht=ct;me==null&&Ht-- >0;)w.has(Se[Ht])||(me=Ht);if(N==0||N==1)for(Ht=ct;Zt==null&&Ht++<Se.length;)w.has(Se[Ht])||(Zt=Ht);if(me!=null||Zt!=null)if(Dt){let qe=me==null?-1/0:F(Ee[me],L,Ft,0),rn=Zt==null?1/0:F(Ee[Zt],L,Ft,0),An=ie-qe,Fe=rn-ie;An<=Fe?An<=Lt&&(vt=me):Fe<=Lt&&(vt=Zt)}else vt=Zt==null?me:me==null?Zt:ct-me<=Zt-ct?me:Zt}else Dt&&vn(ie-F(Ee[ct],L,Ft,0))>Lt&&(vt=null);return vt}}let Jt=y=>{it.event=y};it.idxs=tt,it._lock=!1;let ht=it.points;ht.show=xe(ht.show),ht.size=xe(ht.size),ht.stroke=xe(ht.stroke),ht.width=xe(ht.width),ht.fill=xe(ht.fill);let Ot=n.focus=pn({},i.focus||{alpha:.3},it.focus),Kt=Ot.prox>=0,At=Kt&&ht.one,oe=[],He=[],Bn=[];function Co(y,w){let P=ht.show(n,w);if(P instanceof HTMLElement)return ai(P,c_),ai(P,y.class),qi(P,-10,-10,k,Ct),g.insertBefore(P,oe[w]),P}function Sr(y,w){if(s==1||w>0){let P=s==1&&M[y.scale].time,N=y.value;y.value=P?rp(N)?fp(X,up(N,V)):N||j:N||Sx,y.label=y.label||(P?mx:px)}if(At||w>0){y.width=y.width==null?1:y.width,y.paths=y.paths||Ox||A_,y.fillTo=xe(y.fillTo||Cx),y.pxAlign=+we(y.pxAlign,x),y.pxRound=Mp(y.pxAlign),y.stroke=xe(y.stroke||null),y.fill=xe(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let P=wx(Wn(1,y.width),1),N=y.points=pn({},{size:P,width:Wn(1,P*.2),stroke:y.stroke,space:P*2,paths:Bx,_stroke:null,_fill:null},y.points);N.show=xe(N.show),N.filter=xe(N.filter),N.fill=xe(N.fill),N.stroke=xe(N.stroke),N.paths=xe(N.paths),N.pxAlign=y.pxAlign}if(Z){let P=ge(y,w);Wt.splice(w,0,P[0]),Nt.splice(w,0,P[1]),lt.values.push(null)}if(ft){tt.splice(w,0,null);let P=null;At?w==0&&(P=Co(y,w)):w>0&&(P=Co(y,w)),oe.splice(w,0,P),He.splice(w,0,0),Bn.splice(w,0,0)}Tn("addSeries",w)}function Eh(y,w){w=w??v.length,y=s==1?au(y,w,pp,yp):au(y,w,{},xp),v.splice(w,0,y),Sr(v[w],w)}n.addSeries=Eh;function Fa(y){if(v.splice(y,1),Z){lt.values.splice(y,1),Nt.splice(y,1);let w=Wt.splice(y,1)[0];_n(null,w.firstChild),w.remove()}ft&&(tt.splice(y,1),oe.splice(y,1)[0].remove(),He.splice(y,1),Bn.splice(y,1)),Tn("delSeries",y)}n.delSeries=Fa;let Bi=[!1,!1,!1,!1];function ts(y,w){if(y._show=y.show,y.show){let P=y.side%2,N=M[y.scale];N==null&&(y.scale=P?v[1].scale:S,N=M[y.scale]);let H=N.time;y.size=xe(y.size),y.space=xe(y.space),y.rotate=xe(y.rotate),Ls(y.incrs)&&y.incrs.forEach(ct=>{!Ds.has(ct)&&Ds.set(ct,Np(ct))}),y.incrs=xe(y.incrs||(N.distr==2?Z_:H?p==1?K_:tx:sr)),y.splits=xe(y.splits||(H&&N.distr==1?ot:N.distr==3?iu:N.distr==4?xx:_x)),y.stroke=xe(y.stroke),y.grid.stroke=xe(y.grid.stroke),y.ticks.stroke=xe(y.ticks.stroke),y.border.stroke=xe(y.border.stroke);let K=y.values;y.values=Ls(K)&&!Ls(K[0])?xe(K):H?Ls(K)?hp(X,cp(K,V)):rp(K)?ix(X,K):K||q:K||gx,y.filter=xe(y.filter||(N.distr>=3&&N.log==10?Mx:N.distr==3&&N.log==2?bx:Lp)),y.font=Ep(y.font),y.labelFont=Ep(y.labelFont),y._size=y.size(n,null,w,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(Bi[w]=!0,y._el=vi(r_,f))}}function es(y,w,P,N){let[H,K,ct,pt]=P,vt=w%2,Lt=0;return vt==0&&(pt||K)&&(Lt=w==0&&!H||w==2&&!ct?yn(dp.size/3):0),vt==1&&(H||ct)&&(Lt=w==1&&!K||w==3&&!pt?yn(gp.size/2):0),Lt}let Ro=n.padding=(i.padding||[es,es,es,es]).map(y=>xe(we(y,es))),wi=n._padding=Ro.map((y,w)=>y(n,w,Bi,0)),nn,an=null,ln=null,ki=s==1?v[0].idxs:null,ii=null,Es=!1;function Po(y,w){if(t=y??[],n.data=n._data=t,s==2){nn=0;for(let P=1;P<v.length;P++)nn+=t[P][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),ii=t[0],nn=ii.length;let P=t;if(B==2){P=t.slice();let N=P[0]=Array(nn);for(let H=0;H<nn;H++)N[H]=H}n._data=t=P}if(le(!0),Tn("setData"),B==2&&(yt=!0),w!==!1){let P=L;P.auto(n,Es)?Io():Cs(S,P.min,P.max),et=et||it.left>=0,mt=!0,Nn()}}n.setData=Po;function Io(){Es=!0;let y,w;s==1&&(nn>0?(an=ki[0]=0,ln=ki[1]=nn-1,y=t[0][an],w=t[0][ln],B==2?(y=an,w=ln):y==w&&(B==3?[y,w]=el(y,y,L.log,!1):B==4?[y,w]=uu(y,y,L.log,!1):L.time?w=y+yn(86400/p):[y,w]=ja(y,w,fu,!0))):(an=ki[0]=y=null,ln=ki[1]=w=null)),Cs(S,y,w)}let wr,Ts,Er,T,G,Q,$,J,Et,Rt;function Tt(y,w,P,N,H,K){y??=Gd,P??=pu,N??="butt",H??=Gd,K??="round",y!=wr&&(u.strokeStyle=wr=y),H!=Ts&&(u.fillStyle=Ts=H),w!=Er&&(u.lineWidth=Er=w),K!=G&&(u.lineJoin=G=K),N!=Q&&(u.lineCap=Q=N),P!=T&&u.setLineDash(T=P)}function Pt(y,w,P,N){w!=Ts&&(u.fillStyle=Ts=w),y!=$&&(u.font=$=y),P!=J&&(u.textAlign=J=P),N!=Et&&(u.textBaseline=Et=N)}function zt(y,w,P,N,H=0){if(N.length>0&&y.auto(n,Es)&&(w==null||w.min==null)){let K=we(an,0),ct=we(ln,N.length-1),pt=P.min==null?M_(N,K,ct,H,y.distr==3):[P.min,P.max];y.min=Ri(y.min,P.min=pt[0]),y.max=Wn(y.max,P.max=pt[1])}}let Qt={min:null,max:null};function ue(){for(let N in M){let H=M[N];z[N]==null&&(H.min==null||z[S]!=null&&H.auto(n,Es))&&(z[N]=Qt)}for(let N in M){let H=M[N];z[N]==null&&H.from!=null&&z[H.from]!=null&&(z[N]=Qt)}z[S]!=null&&le(!0);let y={};for(let N in z){let H=z[N];if(H!=null){let K=y[N]=kr(M[N],P_);if(H.min!=null)pn(K,H);else if(N!=S||s==2)if(nn==0&&K.from==null){let ct=K.range(n,null,null,N);K.min=ct[0],K.max=ct[1]}else K.min=ke,K.max=-ke}}if(nn>0){v.forEach((N,H)=>{if(s==1){let K=N.scale,ct=z[K];if(ct==null)return;let pt=y[K];if(H==0){let vt=pt.range(n,pt.min,pt.max,K);pt.min=vt[0],pt.max=vt[1],an=Ci(pt.min,t[0]),ln=Ci(pt.max,t[0]),ln-an>1&&(t[0][an]<pt.min&&an++,t[0][ln]>pt.max&&ln--),N.min=ii[an],N.max=ii[ln]}else N.show&&N.auto&&zt(pt,ct,N,t[H],N.sorted);N.idxs[0]=an,N.idxs[1]=ln}else if(H>0&&N.show&&N.auto){let[K,ct]=N.facets,pt=K.scale,vt=ct.scale,[Lt,Dt]=t[H],Ft=y[pt],ie=y[vt];Ft!=null&&zt(Ft,z[pt],K,Lt,K.sorted),ie!=null&&zt(ie,z[vt],ct,Dt,ct.sorted),N.min=ct.min,N.max=ct.max}});for(let N in y){let H=y[N],K=z[N];if(H.from==null&&(K==null||K.min==null)){let ct=H.range(n,H.min==ke?null:H.min,H.max==-ke?null:H.max,N);H.min=ct[0],H.max=ct[1]}}}for(let N in y){let H=y[N];if(H.from!=null){let K=y[H.from];if(K.min==null)H.min=H.max=null;else{let ct=H.range(n,K.min,K.max,N);H.min=ct[0],H.max=ct[1]}}}let w={},P=!1;for(let N in y){let H=y[N],K=M[N];if(K.min!=H.min||K.max!=H.max){K.min=H.min,K.max=H.max;let ct=K.distr;K._min=ct==3?ls(K.min):ct==4?$h(K.min,K.asinh):ct==100?K.fwd(K.min):K.min,K._max=ct==3?ls(K.max):ct==4?$h(K.max,K.asinh):ct==100?K.fwd(K.max):K.max,w[N]=P=!0}}if(P){v.forEach((N,H)=>{s==2?H>0&&w.y&&(N._paths=null):w[N.scale]&&(N._paths=null)});for(let N in w)yt=!0,Tn("setScale",N);ft&&it.left>=0&&(et=mt=!0)}for(let N in z)z[N]=null}function Bt(y){let w=nu(an-1,0,nn-1),P=nu(ln+1,0,nn-1);for(;y[w]==null&&w>0;)w--;for(;y[P]==null&&P<nn-1;)P++;return[w,P]}function fe(){if(nn>0){let y=v.some(w=>w._focus)&&Rt!=Ot.alpha;y&&(u.globalAlpha=Rt=Ot.alpha),v.forEach((w,P)=>{if(P>0&&w.show&&(je(P,!1),je(P,!0),w._paths==null)){let N=Rt;Rt!=w.alpha&&(u.globalAlpha=Rt=w.alpha);let H=s==2?[0,t[P][0].length-1]:Bt(t[P]);w._paths=w.paths(n,P,H[0],H[1]),Rt!=N&&(u.globalAlpha=Rt=N)}}),v.forEach((w,P)=>{if(P>0&&w.show){let N=Rt;Rt!=w.alpha&&(u.globalAlpha=Rt=w.alpha),w._paths!=null&&Pe(P,!1);{let H=w._paths!=null?w._paths.gaps:null,K=w.points.show(n,P,an,ln,H),ct=w.points.filter(n,P,K,H);(K||ct)&&(w.points._paths=w.points.paths(n,P,an,ln,ct),Pe(P,!0))}Rt!=N&&(u.globalAlpha=Rt=N),Tn("drawSeries",P)}}),y&&(u.globalAlpha=Rt=1)}}function je(y,w){let P=w?v[y].points:v[y];P._stroke=P.stroke(n,y),P._fill=P.fill(n,y)}function Pe(y,w){let P=w?v[y].points:v[y],{stroke:N,fill:H,clip:K,flags:ct,_stroke:pt=P._stroke,_fill:vt=P._fill,_width:Lt=P.width}=P._paths;Lt=ze(Lt*Te,3);let Dt=null,Ft=Lt%2/2;w&&vt==null&&(vt=Lt>0?"#fff":pt);let ie=P.pxAlign==1&&Ft>0;if(ie&&u.translate(Ft,Ft),!w){let Ee=R-Lt/2,Se=b-Lt/2,me=Y+Lt,Zt=ut+Lt;Dt=new Path2D,Dt.rect(Ee,Se,me,Zt)}w?Ut(pt,Lt,P.dash,P.cap,vt,N,H,ct,K):Ie(y,pt,Lt,P.dash,P.cap,vt,N,H,ct,Dt,K),ie&&u.translate(-Ft,-Ft)}function Ie(y,w,P,N,H,K,ct,pt,vt,Lt,Dt){let Ft=!1;vt!=0&&C.forEach((ie,Ee)=>{if(ie.series[0]==y){let Se=v[ie.series[1]],me=t[ie.series[1]],Zt=(Se._paths||Ho).band;Ls(Zt)&&(Zt=ie.dir==1?Zt[0]:Zt[1]);let Ht,qe=null;Se.show&&Zt&&S_(me,an,ln)?(qe=ie.fill(n,Ee)||K,Ht=Se._paths.clip):Zt=null,Ut(w,P,N,H,qe,ct,pt,vt,Lt,Dt,Ht,Zt),Ft=!0}}),Ft||Ut(w,P,N,H,K,ct,pt,vt,Lt,Dt)}let xn=zr|ru;function Ut(y,w,P,N,H,K,ct,pt,vt,Lt,Dt,Ft){Tt(y,w,P,N,H),(vt||Lt||Ft)&&(u.save(),vt&&u.clip(vt),Lt&&u.clip(Lt)),Ft?(pt&xn)==xn?(u.clip(Ft),Dt&&u.clip(Dt),_e(H,ct),hn(y,K,w)):pt&ru?(_e(H,ct),u.clip(Ft),hn(y,K,w)):pt&zr&&(u.save(),u.clip(Ft),Dt&&u.clip(Dt),_e(H,ct),u.restore(),hn(y,K,w)):(_e(H,ct),hn(y,K,w)),(vt||Lt||Ft)&&u.restore()}function hn(y,w,P){P>0&&(w instanceof Map?w.forEach((N,H)=>{u.strokeStyle=wr=H,u.stroke(N)}):w!=null&&y&&u.stroke(w))}function _e(y,w){w instanceof Map?w.forEach((P,N)=>{u.fillStyle=Ts=N,u.fill(P)}):w!=null&&y&&u.fill(w)}function ns(y,w,P,N){let H=A[y],K;if(N<=0)K=[0,0];else{let ct=H._space=H.space(n,y,w,P,N),pt=H._incrs=H.incrs(n,y,w,P,N,ct);K=Wx(w,P,pt,N,ct)}return H._found=K}function un(y,w,P,N,H,K,ct,pt,vt,Lt){let Dt=ct%2/2;x==1&&u.translate(Dt,Dt),Tt(pt,ct,vt,Lt,pt),u.beginPath();let Ft,ie,Ee,Se,me=H+(N==0||N==3?-K:K);P==0?(ie=H,Se=me):(Ft=H,Ee=me);for(let Zt=0;Zt<y.length;Zt++)w[Zt]!=null&&(P==0?Ft=Ee=y[Zt]:ie=Se=y[Zt],u.moveTo(Ft,ie),u.lineTo(Ee,Se));u.stroke(),x==1&&u.translate(-Dt,-Dt)}function Tr(y){let w=!0;return A.forEach((P,N)=>{if(!P.show)return;let H=M[P.scale];if(H.min==null){P._show&&(w=!1,P._show=!1,le(!1));return}else P._show||(w=!1,P._show=!0,le(!1));let K=P.side,ct=K%2,{min:pt,max:vt}=H,[Lt,Dt]=ns(N,pt,vt,ct==0?k:Ct);if(Dt==0)return;let Ft=H.distr==2,ie=P._splits=P.splits(n,N,pt,vt,Lt,Dt,Ft),Ee=H.distr==2?ie.map(Ht=>ii[Ht]):ie,Se=H.distr==2?ii[ie[1]]-ii[ie[0]]:Lt,me=P._values=P.values(n,P.filter(n,Ee,N,Dt,Se),N,Dt,Se);P._rotate=K==2?P.rotate(n,me,N,Dt):0;let Zt=P._size;P._size=Mi(P.size(n,me,N,y)),Zt!=null&&P._size!=Zt&&(w=!1)}),w}function zi(y){let w=!0;return Ro.forEach((P,N)=>{let H=P(n,N,Bi,y);H!=wi[N]&&(w=!1),wi[N]=H}),w}function is(){for(let y=0;y<A.length;y++){let w=A[y];if(!w.show||!w._show)continue;let P=w.side,N=P%2,H,K,ct=w.stroke(n,y),pt=P==0||P==3?-1:1,[vt,Lt]=w._found;if(w.label!=null){let Vn=w.labelGap*pt,oi=yn((w._lpos+Vn)*Te);Pt(w.labelFont[0],ct,"center",P==2?"top":Vd),u.save(),N==1?(H=K=0,u.translate(oi,yn(b+ut/2)),u.rotate((P==3?-Ja:Ja)/2)):(H=yn(R+Y/2),K=oi);let tr=Pp(w.label)?w.label(n,y,vt,Lt):w.label;u.fillText(tr,H,K),u.restore()}if(Lt==0)continue;let Dt=M[w.scale],Ft=N==0?Y:ut,ie=N==0?R:b,Ee=w._splits,Se=Dt.distr==2?Ee.map(Vn=>ii[Vn]):Ee,me=Dt.distr==2?ii[Ee[1]]-ii[Ee[0]]:vt,Zt=w.ticks,Ht=w.border,qe=Zt.show?Zt.size:0,rn=yn(qe*Te),An=yn((w.alignTo==2?w._size-qe-w.gap:w.gap)*Te),Fe=w._rotate*-Ja/180,on=m(w._pos*Te),si=(rn+An)*pt,zn=on+si;K=N==0?zn:0,H=N==1?zn:0;let xi=w.font[0],Ei=w.align==1?Nr:w.align==2?Xh:Fe>0?Nr:Fe<0?Xh:N==0?"center":P==3?Xh:Nr,Hi=Fe||N==1?"middle":P==2?"top":Vd;Pt(xi,ct,Ei,Hi);let ri=w.font[1]*w.lineGap,yi=Ee.map(Vn=>m(a(Vn,Dt,Ft,ie))),Ti=w._values;for(let Vn=0;Vn<Ti.length;Vn++){let oi=Ti[Vn];if(oi!=null){N==0?H=yi[Vn]:K=yi[Vn],oi=""+oi;let tr=oi.indexOf(`
`)==-1?[oi]:oi.split(/\n/gm);for(let Gn=0;Gn<tr.length;Gn++){let vd=tr[Gn];Fe?(u.save(),u.translate(H,K+Gn*ri),u.rotate(Fe),u.fillText(vd,0,0),u.restore()):u.fillText(vd,H,K+Gn*ri)}}}Zt.show&&un(yi,Zt.filter(n,Se,y,Lt,me),N,P,on,rn,ze(Zt.width*Te,3),Zt.stroke(n,y),Zt.dash,Zt.cap);let Wi=w.grid;Wi.show&&un(yi,Wi.filter(n,Se,y,Lt,me),N,N==0?2:1,N==0?b:R,N==0?ut:Y,ze(Wi.width*Te,3),Wi.stroke(n,y),Wi.dash,Wi.cap),Ht.show&&un([on],[1],N==0?1:0,N==0?1:2,N==1?b:R,N==1?ut:Y,ze(Ht.width*Te,3),Ht.stroke(n,y),Ht.dash,Ht.cap)}Tn("drawAxes")}function le(y){v.forEach((w,P)=>{P>0&&(w._paths=null,y&&(s==1?(w.min=null,w.max=null):w.facets.forEach(N=>{N.min=null,N.max=null})))})}let sn=!1,kn=!1,Le=[];function fn(){kn=!1;for(let y=0;y<Le.length;y++)Tn(...Le[y]);Le.length=0}function Nn(){sn||(O_(nd),sn=!0)}function Oa(y,w=!1){sn=!0,kn=w,y(n),nd(),w&&Le.length>0&&queueMicrotask(fn)}n.batch=Oa;function nd(){if(at&&(ue(),at=!1),yt&&(wt(),yt=!1),xt){if(Ye(d,Nr,$t),Ye(d,"top",se),Ye(d,ko,k),Ye(d,zo,Ct),Ye(g,Nr,$t),Ye(g,"top",se),Ye(g,ko,k),Ye(g,zo,Ct),Ye(f,ko,en),Ye(f,zo,cn),h.width=yn(en*Te),h.height=yn(cn*Te),A.forEach(({_el:y,_show:w,_size:P,_pos:N,side:H})=>{if(y!=null)if(w){let K=H===3||H===0?P:0,ct=H%2==1;Ye(y,ct?"left":"top",N-K),Ye(y,ct?"width":"height",P),Ye(y,ct?"top":"left",ct?se:$t),Ye(y,ct?"height":"width",ct?Ct:k),tu(y,rr)}else ai(y,rr)}),wr=Ts=Er=G=Q=$=J=Et=T=null,Rt=1,No(!0),$t!=St||se!=Be||k!=Vt||Ct!=qt){le(!1);let y=k/Vt,w=Ct/qt;if(ft&&!et&&it.left>=0){it.left*=y,it.top*=w,Ar&&qi(Ar,yn(it.left),0,k,Ct),Cr&&qi(Cr,0,yn(it.top),k,Ct);for(let P=0;P<oe.length;P++){let N=oe[P];N!=null&&(He[P]*=y,Bn[P]*=w,qi(N,Mi(He[P]),Mi(Bn[P]),k,Ct))}}if(Xe.show&&!st&&Xe.left>=0&&Xe.width>0){Xe.left*=y,Xe.width*=y,Xe.top*=w,Xe.height*=w;for(let P in Ih)Ye(Ir,P,Xe[P])}St=$t,Be=se,Vt=k,qt=Ct}Tn("setSize"),xt=!1}en>0&&cn>0&&(u.clearRect(0,0,h.width,h.height),Tn("drawClear"),E.forEach(y=>y()),Tn("draw")),Xe.show&&st&&(Ba(Xe),st=!1),ft&&et&&(Qs(null,!0,!1),et=!1),lt.show&&lt.live&&mt&&(Rh(),mt=!1),l||(l=!0,n.status=1,Tn("ready")),Es=!1,sn=!1}n.redraw=(y,w)=>{yt=w||!1,y!==!1?Cs(S,L.min,L.max):Nn()};function Th(y,w){let P=M[y];if(P.from==null){if(nn==0){let N=P.range(n,w.min,w.max,y);w.min=N[0],w.max=N[1]}if(w.min>w.max){let N=w.min;w.min=w.max,w.max=N}if(nn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;y==S&&P.distr==2&&nn>0&&(w.min=Ci(w.min,t[0]),w.max=Ci(w.max,t[0]),w.min==w.max&&w.max++),z[y]=w,at=!0,Nn()}}n.setScale=Th;let Ah,Ch,Ar,Cr,id,sd,Rr,Pr,rd,od,We,Ze,As=!1,In=it.drag,wn=In.x,En=In.y;ft&&(it.x&&(Ah=vi(a_,g)),it.y&&(Ch=vi(l_,g)),L.ori==0?(Ar=Ah,Cr=Ch):(Ar=Ch,Cr=Ah),We=it.left,Ze=it.top);let Xe=n.select=pn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Ir=Xe.show?vi(o_,Xe.over?g:d):null;function Ba(y,w){if(Xe.show){for(let P in y)Xe[P]=y[P],P in Ih&&Ye(Ir,P,y[P]);w!==!1&&Tn("setSelect")}}n.setSelect=Ba;function S0(y){if(v[y].show)Z&&tu(Wt[y],rr);else if(Z&&ai(Wt[y],rr),ft){let P=At?oe[0]:oe[y];P!=null&&qi(P,-10,-10,k,Ct)}}function Cs(y,w,P){Th(y,{min:w,max:P})}function Vi(y,w,P,N){w.focus!=null&&C0(y),w.show!=null&&v.forEach((H,K)=>{K>0&&(y==K||y==null)&&(H.show=w.show,S0(K),s==2?(Cs(H.facets[0].scale,null,null),Cs(H.facets[1].scale,null,null)):Cs(H.scale,null,null),Nn())}),P!==!1&&Tn("setSeries",y,w),N&&Uo("setSeries",n,y,w)}n.setSeries=Vi;function w0(y,w){pn(C[y],w)}function E0(y,w){y.fill=xe(y.fill||null),y.dir=we(y.dir,-1),w=w??C.length,C.splice(w,0,y)}function T0(y){y==null?C.length=0:C.splice(y,1)}n.addBand=E0,n.setBand=w0,n.delBand=T0;function A0(y,w){v[y].alpha=w,ft&&oe[y]!=null&&(oe[y].style.opacity=w),Z&&Wt[y]&&(Wt[y].style.opacity=w)}let ss,Rs,js,Lr={focus:!0};function C0(y){if(y!=js){let w=y==null,P=Ot.alpha!=1;v.forEach((N,H)=>{if(s==1||H>0){let K=w||H==0||H==y;N._focus=w?null:K,P&&A0(H,K?1:Ot.alpha)}}),js=y,P&&Nn()}}Z&&Kt&&be(Xd,Mt,y=>{it._lock||(Jt(y),js!=null&&Vi(null,Lr,!0,dn.setSeries))});function Gi(y,w,P){let N=M[w];P&&(y=y/Te-(N.ori==1?se:$t));let H=k;N.ori==1&&(H=Ct,y=H-y),N.dir==-1&&(y=H-y);let K=N._min,ct=N._max,pt=y/H,vt=K+(ct-K)*pt,Lt=N.distr;return Lt==3?Or(10,vt):Lt==4?E_(vt,N.asinh):Lt==100?N.bwd(vt):vt}function R0(y,w){let P=Gi(y,S,w);return Ci(P,t[0],an,ln)}n.valToIdx=y=>Ci(y,t[0]),n.posToIdx=R0,n.posToVal=Gi,n.valToPos=(y,w,P)=>M[w].ori==0?r(y,M[w],P?Y:k,P?R:0):o(y,M[w],P?ut:Ct,P?b:0),n.setCursor=(y,w,P)=>{We=y.left,Ze=y.top,Qs(null,w,P)};function ad(y,w){Ye(Ir,Nr,Xe.left=y),Ye(Ir,ko,Xe.width=w)}function ld(y,w){Ye(Ir,"top",Xe.top=y),Ye(Ir,zo,Xe.height=w)}let Lo=L.ori==0?ad:ld,Do=L.ori==1?ad:ld;function P0(){if(Z&&lt.live)for(let y=s==2?1:0;y<v.length;y++){if(y==0&&jt)continue;let w=lt.values[y],P=0;for(let N in w)Nt[y][P++].firstChild.nodeValue=w[N]}}function Rh(y,w){if(y!=null&&(y.idxs?y.idxs.forEach((P,N)=>{tt[N]=P}):R_(y.idx)||tt.fill(y.idx),lt.idx=tt[0]),Z&&lt.live){for(let P=0;P<v.length;P++)(P>0||s==1&&!jt)&&I0(P,tt[P]);P0()}mt=!1,w!==!1&&Tn("setLegend")}n.setLegend=Rh;function I0(y,w){let P=v[y],N=y==0&&B==2?ii:t[y],H;jt?H=P.values(n,y,w)??Xt:(H=P.value(n,w==null?null:N[w],y,w),H=H==null?Xt:{_:H}),lt.values[y]=H}function Qs(y,w,P){rd=We,od=Ze,[We,Ze]=it.move(n,We,Ze),it.left=We,it.top=Ze,ft&&(Ar&&qi(Ar,yn(We),0,k,Ct),Cr&&qi(Cr,0,yn(Ze),k,Ct));let N,H=an>ln;ss=ke,Rs=null;let K=L.ori==0?k:Ct,ct=L.ori==1?k:Ct;if(We<0||nn==0||H){N=it.idx=null;for(let pt=0;pt<v.length;pt++){let vt=oe[pt];vt!=null&&qi(vt,-10,-10,k,Ct)}Kt&&Vi(null,Lr,!0,y==null&&dn.setSeries),lt.live&&(tt.fill(N),mt=!0)}else{let pt,vt,Lt;s==1&&(pt=L.ori==0?We:Ze,vt=Gi(pt,S),N=it.idx=Ci(vt,t[0],an,ln),Lt=F(t[0][N],L,K,0));let Dt=-10,Ft=-10,ie=0,Ee=0,Se=!0,me="",Zt="";for(let Ht=s==2?1:0;Ht<v.length;Ht++){let qe=v[Ht],rn=tt[Ht],An=rn==null?null:s==1?t[Ht][rn]:t[Ht][1][rn],Fe=it.dataIdx(n,Ht,N,vt),on=Fe==null?null:s==1?t[Ht][Fe]:t[Ht][1][Fe];if(mt=mt||on!=An||Fe!=rn,tt[Ht]=Fe,Ht>0&&qe.show){let si=Fe==null?-10:Fe==N?Lt:F(s==1?t[0][Fe]:t[Ht][0][Fe],L,K,0),zn=on==null?-10:I(on,s==1?M[qe.scale]:M[qe.facets[1].scale],ct,0);if(Kt&&on!=null){let xi=L.ori==1?We:Ze,Ei=vn(Ot.dist(n,Ht,Fe,zn,xi));if(Ei<ss){let Hi=Ot.bias;if(Hi!=0){let ri=Gi(xi,qe.scale),yi=on>=0?1:-1,Ti=ri>=0?1:-1;Ti==yi&&(Ti==1?Hi==1?on>=ri:on<=ri:Hi==1?on<=ri:on>=ri)&&(ss=Ei,Rs=Ht)}else ss=Ei,Rs=Ht}}if(mt||At){let xi,Ei;L.ori==0?(xi=si,Ei=zn):(xi=zn,Ei=si);let Hi,ri,yi,Ti,Wi,Vn,oi=!0,tr=ht.bbox;if(tr!=null){oi=!1;let Gn=tr(n,Ht);yi=Gn.left,Ti=Gn.top,Hi=Gn.width,ri=Gn.height}else yi=xi,Ti=Ei,Hi=ri=ht.size(n,Ht);if(Vn=ht.fill(n,Ht),Wi=ht.stroke(n,Ht),At)Ht==Rs&&ss<=Ot.prox&&(Dt=yi,Ft=Ti,ie=Hi,Ee=ri,Se=oi,me=Vn,Zt=Wi);else{let Gn=oe[Ht];Gn!=null&&(He[Ht]=yi,Bn[Ht]=Ti,jd(Gn,Hi,ri,oi),Jd(Gn,Vn,Wi),qi(Gn,Mi(yi),Mi(Ti),k,Ct))}}}}if(At){let Ht=Ot.prox,qe=js==null?ss<=Ht:ss>Ht||Rs!=js;if(mt||qe){let rn=oe[0];rn!=null&&(He[0]=Dt,Bn[0]=Ft,jd(rn,ie,Ee,Se),Jd(rn,me,Zt),qi(rn,Mi(Dt),Mi(Ft),k,Ct))}}}if(Xe.show&&As)if(y!=null){let[pt,vt]=dn.scales,[Lt,Dt]=dn.match,[Ft,ie]=y.cursor.sync.scales,Ee=y.cursor.drag;if(wn=Ee._x,En=Ee._y,wn||En){let{left:Se,top:me,width:Zt,height:Ht}=y.select,qe=y.scales[Ft].ori,rn=y.posToVal,An,Fe,on,si,zn,xi=pt!=null&&Lt(pt,Ft),Ei=vt!=null&&Dt(vt,ie);xi&&wn?(qe==0?(An=Se,Fe=Zt):(An=me,Fe=Ht),on=M[pt],si=F(rn(An,Ft),on,K,0),zn=F(rn(An+Fe,Ft),on,K,0),Lo(Ri(si,zn),vn(zn-si))):Lo(0,K),Ei&&En?(qe==1?(An=Se,Fe=Zt):(An=me,Fe=Ht),on=M[vt],si=I(rn(An,ie),on,ct,0),zn=I(rn(An+Fe,ie),on,ct,0),Do(Ri(si,zn),vn(zn-si))):Do(0,ct)}else Lh()}else{let pt=vn(rd-id),vt=vn(od-sd);if(L.ori==1){let ie=pt;pt=vt,vt=ie}wn=In.x&&pt>=In.dist,En=In.y&&vt>=In.dist;let Lt=In.uni;Lt!=null?wn&&En&&(wn=pt>=Lt,En=vt>=Lt,!wn&&!En&&(vt>pt?En=!0:wn=!0)):In.x&&In.y&&(wn||En)&&(wn=En=!0);let Dt,Ft;wn&&(L.ori==0?(Dt=Rr,Ft=We):(Dt=Pr,Ft=Ze),Lo(Ri(Dt,Ft),vn(Ft-Dt)),En||Do(0,ct)),En&&(L.ori==1?(Dt=Rr,Ft=We):(Dt=Pr,Ft=Ze),Do(Ri(Dt,Ft),vn(Ft-Dt)),wn||Lo(0,K)),!wn&&!En&&(Lo(0,0),Do(0,0))}if(In._x=wn,In._y=En,y==null){if(P){if(yd!=null){let[pt,vt]=dn.scales;dn.values[0]=pt!=null?Gi(L.ori==0?We:Ze,pt):null,dn.values[1]=vt!=null?Gi(L.ori==1?We:Ze,vt):null}Uo(qh,n,We,Ze,k,Ct,N)}if(Kt){let pt=P&&dn.setSeries,vt=Ot.prox;js==null?ss<=vt&&Vi(Rs,Lr,!0,pt):ss>vt?Vi(null,Lr,!0,pt):Rs!=js&&Vi(Rs,Lr,!0,pt)}}mt&&(lt.idx=N,Rh()),w!==!1&&Tn("setCursor")}let Ps=null;Object.defineProperty(n,"rect",{get(){return Ps==null&&No(!1),Ps}});function No(y=!1){y?Ps=null:(Ps=g.getBoundingClientRect(),Tn("syncRect",Ps))}function cd(y,w,P,N,H,K,ct){it._lock||As&&y!=null&&y.movementX==0&&y.movementY==0||(Ph(y,w,P,N,H,K,ct,!1,y!=null),y!=null?Qs(null,!0,!0):Qs(w,!0,!1))}function Ph(y,w,P,N,H,K,ct,pt,vt){if(Ps==null&&No(!1),Jt(y),y!=null)P=y.clientX-Ps.left,N=y.clientY-Ps.top;else{if(P<0||N<0){We=-10,Ze=-10;return}let[Lt,Dt]=dn.scales,Ft=w.cursor.sync,[ie,Ee]=Ft.values,[Se,me]=Ft.scales,[Zt,Ht]=dn.match,qe=w.axes[0].side%2==1,rn=L.ori==0?k:Ct,An=L.ori==1?k:Ct,Fe=qe?K:H,on=qe?H:K,si=qe?N:P,zn=qe?P:N;if(Se!=null?P=Zt(Lt,Se)?a(ie,M[Lt],rn,0):-10:P=rn*(si/Fe),me!=null?N=Ht(Dt,me)?a(Ee,M[Dt],An,0):-10:N=An*(zn/on),L.ori==1){let xi=P;P=N,N=xi}}vt&&(w==null||w.cursor.event.type==qh)&&((P<=1||P>=k-1)&&(P=ir(P,k)),(N<=1||N>=Ct-1)&&(N=ir(N,Ct))),pt?(id=P,sd=N,[Rr,Pr]=it.move(n,P,N)):(We=P,Ze=N)}let Ih={width:0,height:0,left:0,top:0};function Lh(){Ba(Ih,!1)}let hd,ud,fd,dd;function pd(y,w,P,N,H,K,ct){As=!0,wn=En=In._x=In._y=!1,Ph(y,w,P,N,H,K,ct,!0,!1),y!=null&&(be(Yh,jh,md,!1),Uo(Hd,n,Rr,Pr,k,Ct,null));let{left:pt,top:vt,width:Lt,height:Dt}=Xe;hd=pt,ud=vt,fd=Lt,dd=Dt}function md(y,w,P,N,H,K,ct){As=In._x=In._y=!1,Ph(y,w,P,N,H,K,ct,!1,!0);let{left:pt,top:vt,width:Lt,height:Dt}=Xe,Ft=Lt>0||Dt>0,ie=hd!=pt||ud!=vt||fd!=Lt||dd!=Dt;if(Ft&&ie&&Ba(Xe),In.setScale&&Ft&&ie){let Ee=pt,Se=Lt,me=vt,Zt=Dt;if(L.ori==1&&(Ee=vt,Se=Dt,me=pt,Zt=Lt),wn&&Cs(S,Gi(Ee,S),Gi(Ee+Se,S)),En)for(let Ht in M){let qe=M[Ht];Ht!=S&&qe.from==null&&qe.min!=ke&&Cs(Ht,Gi(me+Zt,Ht),Gi(me,Ht))}Lh()}else it.lock&&(it._lock=!it._lock,Qs(w,!0,y!=null));y!=null&&(_n(Yh,jh),Uo(Yh,n,We,Ze,k,Ct,null))}function L0(y,w,P,N,H,K,ct){if(it._lock)return;Jt(y);let pt=As;if(As){let vt=!0,Lt=!0,Dt=10,Ft,ie;L.ori==0?(Ft=wn,ie=En):(Ft=En,ie=wn),Ft&&ie&&(vt=We<=Dt||We>=k-Dt,Lt=Ze<=Dt||Ze>=Ct-Dt),Ft&&vt&&(We=We<Rr?0:k),ie&&Lt&&(Ze=Ze<Pr?0:Ct),Qs(null,!0,!0),As=!1}We=-10,Ze=-10,tt.fill(null),Qs(null,!0,!0),pt&&(As=pt)}function gd(y,w,P,N,H,K,ct){it._lock||(Jt(y),Io(),Lh(),y!=null&&Uo(qd,n,We,Ze,k,Ct,null))}function _d(){A.forEach(Xx),O(n.width,n.height,!0)}or(Ka,Fr,_d);let Dr={};Dr.mousedown=pd,Dr.mousemove=cd,Dr.mouseup=md,Dr.dblclick=gd,Dr.setSeries=(y,w,P,N)=>{let H=dn.match[2];P=H(n,w,P),P!=-1&&Vi(P,N,!0,!1)},ft&&(be(Hd,g,pd),be(qh,g,cd),be(Wd,g,y=>{Jt(y),No(!1)}),be(Xd,g,L0),be(qd,g,gd),ou.add(n),n.syncRect=No);let ka=n.hooks=i.hooks||{};function Tn(y,w,P){kn?Le.push([y,w,P]):y in ka&&ka[y].forEach(N=>{N.call(null,n,w,P)})}(i.plugins||[]).forEach(y=>{for(let w in y.hooks)ka[w]=(ka[w]||[]).concat(y.hooks[w])});let xd=(y,w,P)=>P,dn=pn({key:null,setSeries:!1,filters:{pub:ip,sub:ip},scales:[S,v[1]?v[1].scale:null],match:[sp,sp,xd],values:[null,null]},it.sync);dn.match.length==2&&dn.match.push(xd),it.sync=dn;let yd=dn.key,Dh=tm(yd);function Uo(y,w,P,N,H,K,ct){dn.filters.pub(y,w,P,N,H,K,ct)&&Dh.pub(y,w,P,N,H,K,ct)}Dh.sub(n);function D0(y,w,P,N,H,K,ct){dn.filters.sub(y,w,P,N,H,K,ct)&&Dr[y](null,w,P,N,H,K,ct)}n.pub=D0;function N0(){Dh.unsub(n),ou.delete(n),Ke.clear(),eu(Ka,Fr,_d),c.remove(),Mt?.remove(),Tn("destroy")}n.destroy=N0;function Nh(){Tn("init",i,t),Po(t||i.data,!1),z[S]?Th(S,z[S]):Io(),st=Xe.show&&(Xe.width>0||Xe.height>0),et=mt=!0,O(i.width,i.height)}return v.forEach(Sr),A.forEach(ts),e?e instanceof HTMLElement?(e.appendChild(c),Nh()):e(n,Nh):Nh(),n}Ln.assign=pn;Ln.fmtNum=du;Ln.rangeNum=ja;Ln.rangeLog=el;Ln.rangeAsinh=uu;Ln.orient=lr;Ln.pxRatio=Te;Ln.join=F_;Ln.fmtDate=mu,Ln.tzDate=Y_;Ln.sync=tm;{Ln.addGap=Rx,Ln.clipGaps=sl;let i=Ln.paths={points:om};i.linear=lm,i.stepped=Lx,i.bars=Dx,i.spline=Ux}function fm(i,t,{series:e,...n}){let s={stroke:()=>as().grid,width:1},r="12px sans-serif",o=a=>({font:r,labelFont:r,size:a,stroke:()=>as().ink,grid:s,values:(l,c)=>c.map(h=>Kn(h))});return new Ln({width:320,height:200,legend:{show:!1},cursor:{sync:{key:"footfall"},drag:{x:!0,y:!1,setScale:!0},points:{size:6}},axes:[o(34),o(58)],series:[{},...e.map(a=>({width:1.6,points:{show:!1},...a}))],...n,scales:{x:{time:!1},...n.scales}},t,i)}function dm(i,t){let e=document.createElement("li");return e.innerHTML='<span class="dot"></span><span></span><output></output>',e.children[1].textContent=i,e.recolour=()=>e.firstChild.style.background=t(),e.recolour(),e}var bu=Fh.length,qx=1e-12,Su=[" 5 %"," 95 %"],Yx=(i,t)=>Su.some(e=>t.endsWith(e)&&i.has(t.slice(0,-e.length))),pm=(i,t)=>i.has(t+Su[0])?Su.map(e=>t+e):[];function $x(i,t){let e=i.time.at(-1),n=Array.from(t.time).filter(o=>o>e),s=o=>Float32Array.from([...o.subarray(0,i.time.length),...n.map(()=>o[i.time.length-1])]),r=new Map([...i.columns].map(([o,a])=>[o,{...a,values:s(a.values)}]));return{time:Float64Array.from([...i.time,...n]),columns:r,end:e}}var ll=class{constructor(t,e,n,s,r,o=null){this.history=o?$x(e,o.history):e,this.second=o,this.seek=s,this.chosen=n.filter(a=>e.columns.has(a)).slice(0,bu),this.plots=[],this.time=null,this.place=t,t.classList.add("plots"),t.innerHTML=`
      <div class="chooser">
        <input type="search" placeholder="column of the history, for example energy" aria-label="find a column" />
        <ul class="found" hidden></ul>
        <ul class="chosen"></ul>
      </div>
      <div class="drawn"></div>`,this.input=t.querySelector("input"),this.found=t.querySelector(".found"),this.list=t.querySelector(".chosen"),this.drawn=t.querySelector(".drawn"),this.input.addEventListener("input",()=>this.offer()),this.input.addEventListener("focus",()=>this.offer()),this.input.addEventListener("keydown",a=>{a.stopPropagation(),a.key==="Escape"&&this.input.blur(),a.key==="Enter"&&this.found.querySelector("li[data-name]")?.click()}),document.addEventListener("pointerdown",a=>{t.querySelector(".chooser").contains(a.target)||(this.found.hidden=!0)},{signal:r}),new ResizeObserver(()=>this.resize()).observe(this.drawn),Rd(()=>{for(let a of this.list.children)a.recolour();for(let{plot:a}of this.plots)a.redraw()},r),this.draw()}grow(){if(this.plots.some(({names:t,scale:e})=>Ha(this.history.columns.get(t[0]).unit,this.largestOf(t)).unit!==e.unit))return this.draw();for(let{plot:t,names:e,scale:n}of this.plots)t.setData(this.dataOf(e,n.factor));this.showTime(this.time)}largestOf(t){let e=0;for(let n of t.flatMap(s=>[s,...pm(this.history.columns,s)]))for(let s of this.history.columns.get(n).values)e=Math.max(e,Math.abs(s));return e}largestDifference(t){let e=0;for(let n of t)for(let s of this.difference(n))s!==null&&(e=Math.max(e,Math.abs(s)));return e}ofSecond(t){let{history:e}=this.second,n=e.columns.get(t),[s,r]=[e.time[0],e.time.at(-1)];return this.seconds??=new Map,this.seconds.has(t)||this.seconds.set(t,Array.from(this.history.time,o=>n&&o>=s&&o<=r?Ga(e,n.values,o):null)),this.seconds.get(t)}ofFirst(t){let{time:e,columns:n,end:s}=this.history,{values:r}=n.get(t);return Array.from(e,(o,a)=>o<=s?r[a]:null)}difference(t){let e=this.ofFirst(t);return this.ofSecond(t).map((n,s)=>n===null||e[s]===null?null:n-e[s])}dataOf(t,e,n=!1){let s=this.history.time.length,r=a=>a.map(l=>l===null?null:l*e),o=n?[]:this.bandsOf(t);return this.second&&n?[this.history.time,...t.map(a=>r(this.difference(a)))]:this.second?[this.history.time,...t.map(a=>r(this.ofFirst(a))),...t.map(a=>r(this.ofSecond(a))),...o.map(({edge:a,second:l})=>r(l?this.ofSecond(a):this.ofFirst(a)))]:[this.history.time,...t.map(a=>this.history.columns.get(a).values.subarray(0,s).map(l=>l*e))]}bandsOf(t){return this.second?[!1,!0].flatMap(e=>t.flatMap(n=>pm((e?this.second.history:this.history).columns,n).map(s=>({name:n,edge:s,second:e})))):[]}offer(){let t=this.input.value.toLowerCase().split(/\s+/).filter(Boolean),e=[...this.history.columns.keys()].filter(n=>n!=="time"&&!Yx(this.history.columns,n)&&t.every(s=>n.toLowerCase().includes(s)));this.found.replaceChildren(...e.slice(0,200).map(n=>{let s=document.createElement("li");return s.dataset.name=n,s.textContent=`${n} [${this.history.columns.get(n).unit}]`,s.classList.toggle("on",this.chosen.includes(n)),s.addEventListener("click",()=>this.toggle(n)),s})),e.length===0&&(this.found.innerHTML="<li>no column has these letters</li>"),this.found.hidden=!1}toggle(t){if(this.chosen.includes(t))this.chosen=this.chosen.filter(e=>e!==t);else if(this.chosen.length<bu)this.chosen.push(t);else{this.found.innerHTML=`<li>${bu} columns are shown; remove one first</li>`;return}this.draw(),this.found.hidden||this.offer()}colour(t){return Pd(this.chosen.indexOf(t))}draw(){this.list.replaceChildren(...this.chosen.map(e=>{let n=dm(e,()=>this.colour(e)),s=document.createElement("button");return s.textContent="\xD7",s.setAttribute("aria-label",`remove ${e}`),s.addEventListener("click",()=>this.toggle(e)),n.append(s),n}));for(let{plot:e,box:n}of this.plots)e.destroy(),n.remove();let t=[...new Set(this.chosen.map(e=>this.history.columns.get(e).unit))];this.plots=t.map(e=>this.plotOf(e)),this.second&&this.plots.push(...t.map(e=>this.plotOf(e,!0))),this.resize(),this.showTime(this.time)}plotOf(t,e=!1){let n=this.chosen.filter(m=>this.history.columns.get(m).unit===t),s=e?this.largestDifference(n):this.largestOf(n),r=Ha(t,s),o=e?[]:this.bandsOf(n),a=1+2*n.length,l=(m,p="")=>()=>this.colour(m)+p,c={series:[...n.map(m=>({label:m,stroke:l(m)})),...this.second&&!e?n.map(m=>({label:m,stroke:l(m),width:1.4,dash:[6,4]})):[],...o.map(({edge:m})=>({label:m,stroke:"transparent",width:0}))],bands:o.flatMap(({name:m,second:p},v)=>v%2?[]:[{series:[a+v+1,a+v],fill:l(m,p?"22":"44")}]),hooks:{setCursor:[m=>this.showValues(m.cursor.idx)],setScale:[()=>this.showTime(this.time)]}},h=document.createElement("div");h.className="plot";let u=document.createElement("div");u.className="unit";let f=this.second?e?`${this.second.names[1]} \u2212 ${this.second.names[0]} `:`${this.second.names[0]} \u2014, ${this.second.names[1]} - - `:"";u.textContent=`${f}[${r.unit||"-"}] over time [s]`,h.append(u),this.drawn.append(h);let d=fm(h,this.dataOf(n,r.factor,e),c),g=document.createElement("div");g.className="now",d.over.append(g);let x=null;return d.over.addEventListener("pointerdown",m=>x=[m.clientX,m.clientY]),d.over.addEventListener("pointerup",m=>{x&&Math.hypot(m.clientX-x[0],m.clientY-x[1])<4&&this.seek&&this.seek(d.posToVal(m.clientX-d.over.getBoundingClientRect().left,"x"))}),{plot:d,line:g,box:h,names:n,scale:r,differs:e,largest:s}}showTime(t){this.time=t;for(let{plot:e,line:n}of this.plots){let s=t===null?NaN:e.valToPos(t,"x");n.hidden=!(s>=0&&s<=e.over.clientWidth),n.hidden||(n.style.transform=`translateX(${s}px)`)}this.pointed==null&&t!==null&&this.writeValues(this.rowAt(t))}showValues(t){this.pointed=t,t!=null?this.writeValues(t):this.time!==null&&this.writeValues(this.rowAt(this.time))}rowAt(t){let{time:e}=this.history,n=0,s=e.length-1;for(;n<s;){let r=n+s+1>>1;e[r]<=t?n=r:s=r-1}return n+1<e.length&&e[n+1]-t<t-e[n]?n+1:n}writeValues(t){for(let{names:e,scale:n,differs:s,largest:r}of this.plots)for(let o of e){if(s)continue;let a=h=>h===null?"\u2013":Kn(Math.abs(h)<qx*r?0:h*n.factor),l=this.history.columns.get(o).values[t],c=this.second?`${a(this.ofFirst(o)[t])} | ${a(this.ofSecond(o)[t])}`:a(l);this.list.children[this.chosen.indexOf(o)].querySelector("output").textContent=`${c} ${n.unit}`}}resize(){let t=this.drawn.clientWidth;if(!(t>60))return;let e=Math.max(150,Math.min(260,this.plots.length===1?260:190));for(let{plot:n}of this.plots)n.setSize({width:t,height:e});this.showTime(this.time)}};var qs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ys={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Hm=0,ju=1,Wm=2;var ya=1,Xm=2,mo=3,$s=0,Zn=1,Dn=2,pr=0,go=1,Qu=2,tf=3,ef=4,qm=5;var mr=100,Ym=101,$m=102,Zm=103,Jm=104,Km=200,jm=201,Qm=202,tg=203,nf=204,sf=205,eg=206,ng=207,ig=208,sg=209,rg=210,og=211,ag=212,lg=213,cg=214,Bl=0,kl=1,zl=2,ro=3,Vl=4,Gl=5,Hl=6,Wl=7,rf=0,hg=1,ug=2,Ki=0,of=1,af=2,lf=3,cf=4,hf=5,uf=6,ff=7;var df=300,gr=301,_o=302,xc=303,yc=304,Xl=1e3,$i=1001,ql=1002,Rn=1003,fg=1004;var va=1005;var qn=1006,vc=1007;var Ms=1008;var gi=1009,pf=1010,mf=1011,xo=1012,Mc=1013,_i=1014,Ni=1015,Ui=1016,bc=1017,Sc=1018,_r=1020,gf=35902,_f=35899,xf=1021,yf=1022,Fi=1023,_s=1026,bs=1027,vf=1028,yo=1029,Zs=1030,wc=1031;var Ec=1033,Ma=33776,ba=33777,Sa=33778,wa=33779,Tc=35840,Ac=35841,Cc=35842,Rc=35843,Pc=36196,Ic=37492,Lc=37496,Dc=37488,Nc=37489,Ea=37490,Uc=37491,Fc=37808,Oc=37809,Bc=37810,kc=37811,zc=37812,Vc=37813,Gc=37814,Hc=37815,Wc=37816,Xc=37817,qc=37818,Yc=37819,$c=37820,Zc=37821,Jc=36492,Kc=36494,jc=36495,Qc=36283,th=36284,Ta=36285,eh=36286;var jo=2300,Yl=2301,Fl=2302,Xu=2303,qu=2400,Yu=2401,$u=2402;var dg=3200;var Mf=0,pg=1,Ss="",fi="srgb",Qo="srgb-linear",ta="linear",Re="srgb";var Ol=7680;var mg=519,gg=512,_g=513,xg=514,bf=515,yg=516,vg=517,Sf=518,wf=519,Mg=35044;var Ef="300 es",Si=2e3,ea=2001;function Zx(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Jx(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function na(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function bg(){let i=na("canvas");return i.style.display="block",i}var mm={},oo=null;function Tf(...i){let t="THREE."+i.shift();oo?oo("log",t,...i):console.log(t,...i)}function Sg(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Yt(...i){i=Sg(i);let t="THREE."+i.shift();if(oo)oo("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function te(...i){i=Sg(i);let t="THREE."+i.shift();if(oo)oo("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function Jo(...i){let t=i.join(" ");t in mm||(mm[t]=!0,Yt(...i))}function wg(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var Eg={[Bl]:Bl,[zl]:Hl,[Vl]:Vl,[ro]:Gl,[kl]:kl,[Hl]:zl,[Wl]:Wl,[Gl]:ro},Di=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Un=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],gm=1234567,io=Math.PI/180,ao=180/Math.PI;function vo(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Un[i&255]+Un[i>>8&255]+Un[i>>16&255]+Un[i>>24&255]+"-"+Un[t&255]+Un[t>>8&255]+"-"+Un[t>>16&15|64]+Un[t>>24&255]+"-"+Un[e&63|128]+Un[e>>8&255]+"-"+Un[e>>16&255]+Un[e>>24&255]+Un[n&255]+Un[n>>8&255]+Un[n>>16&255]+Un[n>>24&255]).toLowerCase()}function de(i,t,e){return Math.max(t,Math.min(e,i))}function Af(i,t){return(i%t+t)%t}function Kx(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function jx(i,t,e){return i!==t?(e-i)/(t-i):0}function Ko(i,t,e){return(1-e)*i+e*t}function Qx(i,t,e,n){return Ko(i,t,1-Math.exp(-e*n))}function ty(i,t=1){return t-Math.abs(Af(i,t*2)-t)}function ey(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function ny(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function iy(i,t){return i+Math.floor(Math.random()*(t-i+1))}function sy(i,t){return i+Math.random()*(t-i)}function ry(i){return i*(.5-Math.random())}function oy(i){i!==void 0&&(gm=i);let t=gm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function ay(i){return i*io}function ly(i){return i*ao}function cy(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function hy(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Cf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function uy(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),u=r((t-n)/2),f=o((t-n)/2),d=r((n-t)/2),g=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*u,l*f,a*c);break;case"YZY":i.set(l*f,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*f,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*d,a*c);break;case"YXY":i.set(l*d,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*d,a*h,a*c);break;default:Yt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Rf(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Tg(i,t){if(t.constructor===Float32Array)return i;let e=Rf(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Ag(i,t){if(t.constructor===Float32Array)return i;let e=Rf(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var Pf={DEG2RAD:io,RAD2DEG:ao,generateUUID:vo,clamp:de,euclideanModulo:Af,mapLinear:Kx,inverseLerp:jx,lerp:Ko,damp:Qx,pingpong:ty,smoothstep:ey,smootherstep:ny,randInt:iy,randFloat:sy,randFloatSpread:ry,seededRandom:oy,degToRad:ay,radToDeg:ly,isPowerOfTwo:cy,ceilPowerOfTwo:hy,floorPowerOfTwo:Cf,setQuaternionFromProperEuler:uy,normalize:Ag,denormalize:Tg},re=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=de(this.x,t.x,e.x),this.y=de(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=de(this.x,t,e),this.y=de(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(de(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(de(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Yn=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],f=r[o+0],d=r[o+1],g=r[o+2],x=r[o+3];if(u!==x||l!==f||c!==d||h!==g){let m=l*f+c*d+h*g+u*x;m<0&&(f=-f,d=-d,g=-g,x=-x,m=-m);let p=1-a;if(m<.9995){let v=Math.acos(m),A=Math.sin(v);p=Math.sin(p*v)/A,a=Math.sin(a*v)/A,l=l*p+f*a,c=c*p+d*a,h=h*p+g*a,u=u*p+x*a}else{l=l*p+f*a,c=c*p+d*a,h=h*p+g*a,u=u*p+x*a;let v=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=v,c*=v,h*=v,u*=v}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],f=r[o+1],d=r[o+2],g=r[o+3];return t[e]=a*g+h*u+l*d-c*f,t[e+1]=l*g+h*f+c*u-a*d,t[e+2]=c*g+h*d+a*f-l*u,t[e+3]=h*g-a*u-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),f=l(n/2),d=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*h*u+c*d*g,this._y=c*d*u-f*h*g,this._z=c*h*g+f*d*u,this._w=c*h*u-f*d*g;break;case"YXZ":this._x=f*h*u+c*d*g,this._y=c*d*u-f*h*g,this._z=c*h*g-f*d*u,this._w=c*h*u+f*d*g;break;case"ZXY":this._x=f*h*u-c*d*g,this._y=c*d*u+f*h*g,this._z=c*h*g+f*d*u,this._w=c*h*u-f*d*g;break;case"ZYX":this._x=f*h*u-c*d*g,this._y=c*d*u+f*h*g,this._z=c*h*g-f*d*u,this._w=c*h*u+f*d*g;break;case"YZX":this._x=f*h*u+c*d*g,this._y=c*d*u+f*h*g,this._z=c*h*g-f*d*u,this._w=c*h*u-f*d*g;break;case"XZY":this._x=f*h*u-c*d*g,this._y=c*d*u-f*h*g,this._z=c*h*g+f*d*u,this._w=c*h*u+f*d*g;break;default:Yt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],f=n+a+u;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(h-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>u){let d=2*Math.sqrt(1+n-a-u);this._w=(h-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>u){let d=2*Math.sqrt(1+a-n-u);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+h)/d}else{let d=2*Math.sqrt(1+u-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(de(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},W=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(_m.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(_m.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=de(this.x,t.x,e.x),this.y=de(this.y,t.y,e.y),this.z=de(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=de(this.x,t,e),this.y=de(this.y,t,e),this.z=de(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(de(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return wu.copy(this).projectOnVector(t),this.sub(wu)}reflect(t){return this.sub(wu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(de(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},wu=new W,_m=new Yn,ne=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],f=n[2],d=n[5],g=n[8],x=s[0],m=s[3],p=s[6],v=s[1],A=s[4],M=s[7],C=s[2],S=s[5],_=s[8];return r[0]=o*x+a*v+l*C,r[3]=o*m+a*A+l*S,r[6]=o*p+a*M+l*_,r[1]=c*x+h*v+u*C,r[4]=c*m+h*A+u*S,r[7]=c*p+h*M+u*_,r[2]=f*x+d*v+g*C,r[5]=f*m+d*A+g*S,r[8]=f*p+d*M+g*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,f=a*l-h*r,d=c*r-o*l,g=e*u+n*f+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/g;return t[0]=u*x,t[1]=(s*c-h*n)*x,t[2]=(a*n-s*o)*x,t[3]=f*x,t[4]=(h*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=d*x,t[7]=(n*l-c*e)*x,t[8]=(o*e-n*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Jo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Eu.makeScale(t,e)),this}rotate(t){return Jo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Eu.makeRotation(-t)),this}translate(t,e){return Jo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Eu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Eu=new ne,xm=new ne().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),ym=new ne().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function fy(){let i={enabled:!0,workingColorSpace:Qo,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Re&&(s.r=gs(s.r),s.g=gs(s.g),s.b=gs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Re&&(s.r=so(s.r),s.g=so(s.g),s.b=so(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ss?ta:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Qo]:{primaries:t,whitePoint:n,transfer:ta,toXYZ:xm,fromXYZ:ym,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:fi},outputColorSpaceConfig:{drawingBufferColorSpace:fi}},[fi]:{primaries:t,whitePoint:n,transfer:Re,toXYZ:xm,fromXYZ:ym,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:fi}}}),i}var ye=fy();function gs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function so(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Wr,$l=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Wr===void 0&&(Wr=na("canvas")),Wr.width=t.width,Wr.height=t.height;let s=Wr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Wr}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=na("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=gs(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(gs(e[n]/255)*255):e[n]=gs(e[n]);return{data:e,width:t.width,height:t.height}}else return Yt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},dy=0,lo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:dy++}),this.uuid=vo(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Tu(s[o].image)):r.push(Tu(s[o]))}else r=Tu(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function Tu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?$l.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Yt("Texture: Unable to serialize Texture."),{})}var py=0,Au=new W,jn=class i extends Di{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=$i,s=$i,r=qn,o=Ms,a=Fi,l=gi,c=i.DEFAULT_ANISOTROPY,h=Ss){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:py++}),this.uuid=vo(),this.name="",this.source=new lo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new re(0,0),this.repeat=new re(1,1),this.center=new re(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ne,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Au).x}get height(){return this.source.getSize(Au).y}get depth(){return this.source.getSize(Au).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Yt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Yt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==df)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Xl:t.x=t.x-Math.floor(t.x);break;case $i:t.x=t.x<0?0:1;break;case ql:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Xl:t.y=t.y-Math.floor(t.y);break;case $i:t.y=t.y<0?0:1;break;case ql:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};jn.DEFAULT_IMAGE=null;jn.DEFAULT_MAPPING=df;jn.DEFAULT_ANISOTROPY=1;var De=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],f=l[1],d=l[5],g=l[9],x=l[2],m=l[6],p=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-x)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+x)<.1&&Math.abs(g+m)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let A=(c+1)/2,M=(d+1)/2,C=(p+1)/2,S=(h+f)/4,_=(u+x)/4,E=(g+m)/4;return A>M&&A>C?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=S/n,r=_/n):M>C?M<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),n=S/s,r=E/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=_/r,s=E/r),this.set(n,s,r,e),this}let v=Math.sqrt((m-g)*(m-g)+(u-x)*(u-x)+(f-h)*(f-h));return Math.abs(v)<.001&&(v=1),this.x=(m-g)/v,this.y=(u-x)/v,this.z=(f-h)/v,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=de(this.x,t.x,e.x),this.y=de(this.y,t.y,e.y),this.z=de(this.z,t.z,e.z),this.w=de(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=de(this.x,t,e),this.y=de(this.y,t,e),this.z=de(this.z,t,e),this.w=de(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(de(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Zl=class extends Di{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:qn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new De(0,0,t,e),this.scissorTest=!1,this.viewport=new De(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new jn({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:qn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new lo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},pi=class extends Zl{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},ia=class extends jn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Rn,this.minFilter=Rn,this.wrapR=$i,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Jl=class extends jn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Rn,this.minFilter=Rn,this.wrapR=$i,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Je=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,u,f,d,g,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,u,f,d,g,x,m)}set(t,e,n,s,r,o,a,l,c,h,u,f,d,g,x,m){let p=this.elements;return p[0]=t,p[4]=e,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=u,p[14]=f,p[3]=d,p[7]=g,p[11]=x,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/Xr.setFromMatrixColumn(t,0).length(),r=1/Xr.setFromMatrixColumn(t,1).length(),o=1/Xr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let f=o*h,d=o*u,g=a*h,x=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=d+g*c,e[5]=f-x*c,e[9]=-a*l,e[2]=x-f*c,e[6]=g+d*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*h,d=l*u,g=c*h,x=c*u;e[0]=f+x*a,e[4]=g*a-d,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=d*a-g,e[6]=x+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*h,d=l*u,g=c*h,x=c*u;e[0]=f-x*a,e[4]=-o*u,e[8]=g+d*a,e[1]=d+g*a,e[5]=o*h,e[9]=x-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*h,d=o*u,g=a*h,x=a*u;e[0]=l*h,e[4]=g*c-d,e[8]=f*c+x,e[1]=l*u,e[5]=x*c+f,e[9]=d*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,d=o*c,g=a*l,x=a*c;e[0]=l*h,e[4]=x-f*u,e[8]=g*u+d,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=d*u+g,e[10]=f-x*u}else if(t.order==="XZY"){let f=o*l,d=o*c,g=a*l,x=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=f*u+x,e[5]=o*h,e[9]=d*u-g,e[2]=g*u-d,e[6]=a*h,e[10]=x*u+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(my,t,gy)}lookAt(t,e,n){let s=this.elements;return hi.subVectors(t,e),hi.lengthSq()===0&&(hi.z=1),hi.normalize(),Ns.crossVectors(n,hi),Ns.lengthSq()===0&&(Math.abs(n.z)===1?hi.x+=1e-4:hi.z+=1e-4,hi.normalize(),Ns.crossVectors(n,hi)),Ns.normalize(),cl.crossVectors(hi,Ns),s[0]=Ns.x,s[4]=cl.x,s[8]=hi.x,s[1]=Ns.y,s[5]=cl.y,s[9]=hi.y,s[2]=Ns.z,s[6]=cl.z,s[10]=hi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],f=n[9],d=n[13],g=n[2],x=n[6],m=n[10],p=n[14],v=n[3],A=n[7],M=n[11],C=n[15],S=s[0],_=s[4],E=s[8],U=s[12],D=s[1],L=s[5],B=s[9],F=s[13],I=s[2],z=s[6],X=s[10],V=s[14],ot=s[3],q=s[7],j=s[11],tt=s[15];return r[0]=o*S+a*D+l*I+c*ot,r[4]=o*_+a*L+l*z+c*q,r[8]=o*E+a*B+l*X+c*j,r[12]=o*U+a*F+l*V+c*tt,r[1]=h*S+u*D+f*I+d*ot,r[5]=h*_+u*L+f*z+d*q,r[9]=h*E+u*B+f*X+d*j,r[13]=h*U+u*F+f*V+d*tt,r[2]=g*S+x*D+m*I+p*ot,r[6]=g*_+x*L+m*z+p*q,r[10]=g*E+x*B+m*X+p*j,r[14]=g*U+x*F+m*V+p*tt,r[3]=v*S+A*D+M*I+C*ot,r[7]=v*_+A*L+M*z+C*q,r[11]=v*E+A*B+M*X+C*j,r[15]=v*U+A*F+M*V+C*tt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],f=t[10],d=t[14],g=t[3],x=t[7],m=t[11],p=t[15],v=l*d-c*f,A=a*d-c*u,M=a*f-l*u,C=o*d-c*h,S=o*f-l*h,_=o*u-a*h;return e*(x*v-m*A+p*M)-n*(g*v-m*C+p*S)+s*(g*A-x*C+p*_)-r*(g*M-x*S+m*_)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],f=t[10],d=t[11],g=t[12],x=t[13],m=t[14],p=t[15],v=e*a-n*o,A=e*l-s*o,M=e*c-r*o,C=n*l-s*a,S=n*c-r*a,_=s*c-r*l,E=h*x-u*g,U=h*m-f*g,D=h*p-d*g,L=u*m-f*x,B=u*p-d*x,F=f*p-d*m,I=v*F-A*B+M*L+C*D-S*U+_*E;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let z=1/I;return t[0]=(a*F-l*B+c*L)*z,t[1]=(s*B-n*F-r*L)*z,t[2]=(x*_-m*S+p*C)*z,t[3]=(f*S-u*_-d*C)*z,t[4]=(l*D-o*F-c*U)*z,t[5]=(e*F-s*D+r*U)*z,t[6]=(m*M-g*_-p*A)*z,t[7]=(h*_-f*M+d*A)*z,t[8]=(o*B-a*D+c*E)*z,t[9]=(n*D-e*B-r*E)*z,t[10]=(g*S-x*M+p*v)*z,t[11]=(u*M-h*S-d*v)*z,t[12]=(a*U-o*L-l*E)*z,t[13]=(e*L-n*U+s*E)*z,t[14]=(x*A-g*C-m*v)*z,t[15]=(h*C-u*A+f*v)*z,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,f=r*c,d=r*h,g=r*u,x=o*h,m=o*u,p=a*u,v=l*c,A=l*h,M=l*u,C=n.x,S=n.y,_=n.z;return s[0]=(1-(x+p))*C,s[1]=(d+M)*C,s[2]=(g-A)*C,s[3]=0,s[4]=(d-M)*S,s[5]=(1-(f+p))*S,s[6]=(m+v)*S,s[7]=0,s[8]=(g+A)*_,s[9]=(m-v)*_,s[10]=(1-(f+x))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=Xr.set(s[0],s[1],s[2]).length(),a=Xr.set(s[4],s[5],s[6]).length(),l=Xr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Pi.copy(this);let c=1/o,h=1/a,u=1/l;return Pi.elements[0]*=c,Pi.elements[1]*=c,Pi.elements[2]*=c,Pi.elements[4]*=h,Pi.elements[5]*=h,Pi.elements[6]*=h,Pi.elements[8]*=u,Pi.elements[9]*=u,Pi.elements[10]*=u,e.setFromRotationMatrix(Pi),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=Si,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(n-s),f=(e+t)/(e-t),d=(n+s)/(n-s),g,x;if(l)g=r/(o-r),x=o*r/(o-r);else if(a===Si)g=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===ea)g=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=u,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Si,l=!1){let c=this.elements,h=2/(e-t),u=2/(n-s),f=-(e+t)/(e-t),d=-(n+s)/(n-s),g,x;if(l)g=1/(o-r),x=o/(o-r);else if(a===Si)g=-2/(o-r),x=-(o+r)/(o-r);else if(a===ea)g=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=u,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=g,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Xr=new W,Pi=new Je,my=new W(0,0,0),gy=new W(1,1,1),Ns=new W,cl=new W,hi=new W,vm=new Je,Mm=new Yn,ks=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(de(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-de(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(de(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-de(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(de(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-de(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,d),this._y=0);break;default:Yt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return vm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(vm,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Mm.setFromEuler(this),this.setFromQuaternion(Mm,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ks.DEFAULT_ORDER="XYZ";var sa=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},_y=0,bm=new W,qr=new Yn,hs=new Je,hl=new W,Xo=new W,xy=new W,yy=new Yn,Sm=new W(1,0,0),wm=new W(0,1,0),Em=new W(0,0,1),Tm={type:"added"},vy={type:"removed"},Yr={type:"childadded",child:null},Cu={type:"childremoved",child:null},$n=class i extends Di{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:_y++}),this.uuid=vo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new W,e=new ks,n=new Yn,s=new W(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Je},normalMatrix:{value:new ne}}),this.matrix=new Je,this.matrixWorld=new Je,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new sa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return qr.setFromAxisAngle(t,e),this.quaternion.multiply(qr),this}rotateOnWorldAxis(t,e){return qr.setFromAxisAngle(t,e),this.quaternion.premultiply(qr),this}rotateX(t){return this.rotateOnAxis(Sm,t)}rotateY(t){return this.rotateOnAxis(wm,t)}rotateZ(t){return this.rotateOnAxis(Em,t)}translateOnAxis(t,e){return bm.copy(t).applyQuaternion(this.quaternion),this.position.add(bm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Sm,t)}translateY(t){return this.translateOnAxis(wm,t)}translateZ(t){return this.translateOnAxis(Em,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(hs.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?hl.copy(t):hl.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Xo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?hs.lookAt(Xo,hl,this.up):hs.lookAt(hl,Xo,this.up),this.quaternion.setFromRotationMatrix(hs),s&&(hs.extractRotation(s.matrixWorld),qr.setFromRotationMatrix(hs),this.quaternion.premultiply(qr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(te("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Tm),Yr.child=t,this.dispatchEvent(Yr),Yr.child=null):te("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(vy),Cu.child=t,this.dispatchEvent(Cu),Cu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),hs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),hs.multiply(t.parent.matrixWorld)),t.applyMatrix4(hs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Tm),Yr.child=t,this.dispatchEvent(Yr),Yr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Xo,t,xy),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Xo,yy,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),f=o(t.skeletons),d=o(t.animations),g=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};$n.DEFAULT_UP=new W(0,1,0);$n.DEFAULT_MATRIX_AUTO_UPDATE=!0;$n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Qe=class extends $n{constructor(){super(),this.isGroup=!0,this.type="Group"}},My={type:"move"},co=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Qe,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Qe,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new W,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new W),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Qe,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new W,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new W,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let m=e.getJointPose(x,n),p=this._getHandJoint(c,x);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),d=.02,g=.005;c.inputState.pinching&&f>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(My)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Qe;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},Cg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Us={h:0,s:0,l:0},ul={h:0,s:0,l:0};function Ru(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var pe=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=fi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ye.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=ye.workingColorSpace){return this.r=t,this.g=e,this.b=n,ye.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=ye.workingColorSpace){if(t=Af(t,1),e=de(e,0,1),n=de(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=Ru(o,r,t+1/3),this.g=Ru(o,r,t),this.b=Ru(o,r,t-1/3)}return ye.colorSpaceToWorking(this,s),this}setStyle(t,e=fi){function n(r){r!==void 0&&parseFloat(r)<1&&Yt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Yt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Yt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=fi){let n=Cg[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Yt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=gs(t.r),this.g=gs(t.g),this.b=gs(t.b),this}copyLinearToSRGB(t){return this.r=so(t.r),this.g=so(t.g),this.b=so(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=fi){return ye.workingToColorSpace(Fn.copy(this),t),Math.round(de(Fn.r*255,0,255))*65536+Math.round(de(Fn.g*255,0,255))*256+Math.round(de(Fn.b*255,0,255))}getHexString(t=fi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ye.workingColorSpace){ye.workingToColorSpace(Fn.copy(this),e);let n=Fn.r,s=Fn.g,r=Fn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=ye.workingColorSpace){return ye.workingToColorSpace(Fn.copy(this),e),t.r=Fn.r,t.g=Fn.g,t.b=Fn.b,t}getStyle(t=fi){ye.workingToColorSpace(Fn.copy(this),t);let e=Fn.r,n=Fn.g,s=Fn.b;return t!==fi?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Us),this.setHSL(Us.h+t,Us.s+e,Us.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Us),t.getHSL(ul);let n=Ko(Us.h,ul.h,e),s=Ko(Us.s,ul.s,e),r=Ko(Us.l,ul.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Fn=new pe;pe.NAMES=Cg;var ra=class extends $n{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ks,this.environmentIntensity=1,this.environmentRotation=new ks,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ii=new W,us=new W,Pu=new W,fs=new W,$r=new W,Zr=new W,Am=new W,Iu=new W,Lu=new W,Du=new W,Nu=new De,Uu=new De,Fu=new De,ms=class i{constructor(t=new W,e=new W,n=new W){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Ii.subVectors(t,e),s.cross(Ii);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Ii.subVectors(s,e),us.subVectors(n,e),Pu.subVectors(t,e);let o=Ii.dot(Ii),a=Ii.dot(us),l=Ii.dot(Pu),c=us.dot(us),h=us.dot(Pu),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let f=1/u,d=(c*l-a*h)*f,g=(o*h-a*l)*f;return r.set(1-d-g,g,d)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,fs)===null?!1:fs.x>=0&&fs.y>=0&&fs.x+fs.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,fs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,fs.x),l.addScaledVector(o,fs.y),l.addScaledVector(a,fs.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return Nu.setScalar(0),Uu.setScalar(0),Fu.setScalar(0),Nu.fromBufferAttribute(t,e),Uu.fromBufferAttribute(t,n),Fu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Nu,r.x),o.addScaledVector(Uu,r.y),o.addScaledVector(Fu,r.z),o}static isFrontFacing(t,e,n,s){return Ii.subVectors(n,e),us.subVectors(t,e),Ii.cross(us).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ii.subVectors(this.c,this.b),us.subVectors(this.a,this.b),Ii.cross(us).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;$r.subVectors(s,n),Zr.subVectors(r,n),Iu.subVectors(t,n);let l=$r.dot(Iu),c=Zr.dot(Iu);if(l<=0&&c<=0)return e.copy(n);Lu.subVectors(t,s);let h=$r.dot(Lu),u=Zr.dot(Lu);if(h>=0&&u<=h)return e.copy(s);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector($r,o);Du.subVectors(t,r);let d=$r.dot(Du),g=Zr.dot(Du);if(g>=0&&d<=g)return e.copy(r);let x=d*c-l*g;if(x<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(n).addScaledVector(Zr,a);let m=h*g-d*u;if(m<=0&&u-h>=0&&d-g>=0)return Am.subVectors(r,s),a=(u-h)/(u-h+(d-g)),e.copy(s).addScaledVector(Am,a);let p=1/(m+x+f);return o=x*p,a=f*p,e.copy(n).addScaledVector($r,o).addScaledVector(Zr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Qn=class{constructor(t=new W(1/0,1/0,1/0),e=new W(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Li.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Li.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Li.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Li):Li.fromBufferAttribute(r,o),Li.applyMatrix4(t.matrixWorld),this.expandByPoint(Li);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),fl.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),fl.copy(n.boundingBox)),fl.applyMatrix4(t.matrixWorld),this.union(fl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Li),Li.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(qo),dl.subVectors(this.max,qo),Jr.subVectors(t.a,qo),Kr.subVectors(t.b,qo),jr.subVectors(t.c,qo),Fs.subVectors(Kr,Jr),Os.subVectors(jr,Kr),cr.subVectors(Jr,jr);let e=[0,-Fs.z,Fs.y,0,-Os.z,Os.y,0,-cr.z,cr.y,Fs.z,0,-Fs.x,Os.z,0,-Os.x,cr.z,0,-cr.x,-Fs.y,Fs.x,0,-Os.y,Os.x,0,-cr.y,cr.x,0];return!Ou(e,Jr,Kr,jr,dl)||(e=[1,0,0,0,1,0,0,0,1],!Ou(e,Jr,Kr,jr,dl))?!1:(pl.crossVectors(Fs,Os),e=[pl.x,pl.y,pl.z],Ou(e,Jr,Kr,jr,dl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Li).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Li).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ds[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ds[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ds[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ds[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ds[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ds[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ds[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ds[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ds),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ds=[new W,new W,new W,new W,new W,new W,new W,new W],Li=new W,fl=new Qn,Jr=new W,Kr=new W,jr=new W,Fs=new W,Os=new W,cr=new W,qo=new W,dl=new W,pl=new W,hr=new W;function Ou(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){hr.fromArray(i,r);let a=s.x*Math.abs(hr.x)+s.y*Math.abs(hr.y)+s.z*Math.abs(hr.z),l=t.dot(hr),c=e.dot(hr),h=n.dot(hr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var mn=new W,ml=new re,by=0,Ve=class extends Di{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:by++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Mg,this.updateRanges=[],this.gpuType=Ni,this.version=0,this._normalizationScale=t!==void 0?Rf(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)ml.fromBufferAttribute(this,e),ml.applyMatrix3(t),this.setXY(e,ml.x,ml.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix3(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix4(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyNormalMatrix(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.transformDirection(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Tg(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Ag(t,this.array)}};var oa=class extends Ve{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var aa=class extends Ve{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Ge=class extends Ve{constructor(t,e,n){super(new Float32Array(t),e,n)}},Sy=new Qn,Yo=new W,Bu=new W,zs=class{constructor(t=new W,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Sy.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Yo.subVectors(t,this.center);let e=Yo.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Yo,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Bu.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Yo.copy(t.center).add(Bu)),this.expandByPoint(Yo.copy(t.center).sub(Bu))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},wy=0,bi=new Je,ku=new $n,Qr=new W,ui=new Qn,$o=new Qn,Cn=new W,Oe=class i extends Di{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:wy++}),this.uuid=vo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Zx(t)?aa:oa)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ne().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return bi.makeRotationFromQuaternion(t),this.applyMatrix4(bi),this}rotateX(t){return bi.makeRotationX(t),this.applyMatrix4(bi),this}rotateY(t){return bi.makeRotationY(t),this.applyMatrix4(bi),this}rotateZ(t){return bi.makeRotationZ(t),this.applyMatrix4(bi),this}translate(t,e,n){return bi.makeTranslation(t,e,n),this.applyMatrix4(bi),this}scale(t,e,n){return bi.makeScale(t,e,n),this.applyMatrix4(bi),this}lookAt(t){return ku.lookAt(t),ku.updateMatrix(),this.applyMatrix4(ku.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Qr).negate(),this.translate(Qr.x,Qr.y,Qr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ge(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Yt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Qn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){te("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new W(-1/0,-1/0,-1/0),new W(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];ui.setFromBufferAttribute(r),this.morphTargetsRelative?(Cn.addVectors(this.boundingBox.min,ui.min),this.boundingBox.expandByPoint(Cn),Cn.addVectors(this.boundingBox.max,ui.max),this.boundingBox.expandByPoint(Cn)):(this.boundingBox.expandByPoint(ui.min),this.boundingBox.expandByPoint(ui.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&te('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new zs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){te("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new W,1/0);return}if(t){let n=this.boundingSphere.center;if(ui.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];$o.setFromBufferAttribute(a),this.morphTargetsRelative?(Cn.addVectors(ui.min,$o.min),ui.expandByPoint(Cn),Cn.addVectors(ui.max,$o.max),ui.expandByPoint(Cn)):(ui.expandByPoint($o.min),ui.expandByPoint($o.max))}ui.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Cn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Cn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Cn.fromBufferAttribute(a,c),l&&(Qr.fromBufferAttribute(t,c),Cn.add(Qr)),s=Math.max(s,n.distanceToSquared(Cn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&te('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){te("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Ve(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let U=0;U<n.count;U++)a[U]=new W,l[U]=new W;let h=new W,u=new W,f=new W,d=new re,g=new re,x=new re,m=new W,p=new W;function v(U,D,L){c[U]=c[D]=c[L]=1,h.fromBufferAttribute(n,U),u.fromBufferAttribute(n,D),f.fromBufferAttribute(n,L),d.fromBufferAttribute(r,U),g.fromBufferAttribute(r,D),x.fromBufferAttribute(r,L),u.sub(h),f.sub(h),g.sub(d),x.sub(d);let B=1/(g.x*x.y-x.x*g.y);isFinite(B)&&(m.copy(u).multiplyScalar(x.y).addScaledVector(f,-g.y).multiplyScalar(B),p.copy(f).multiplyScalar(g.x).addScaledVector(u,-x.x).multiplyScalar(B),a[U].add(m),a[D].add(m),a[L].add(m),l[U].add(p),l[D].add(p),l[L].add(p))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let U=0,D=A.length;U<D;++U){let L=A[U],B=L.start,F=L.count;for(let I=B,z=B+F;I<z;I+=3)v(t.getX(I+0),t.getX(I+1),t.getX(I+2))}let M=new W,C=new W,S=new W,_=new W;function E(U){S.fromBufferAttribute(s,U),_.copy(S);let D=a[U];M.copy(D),M.sub(S.multiplyScalar(S.dot(D))).normalize(),C.crossVectors(_,D);let B=C.dot(l[U])<0?-1:1;o.setXYZW(U,M.x,M.y,M.z,B)}for(let U=0,D=n.count;U<D;++U)c[U]&&E(U);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Ve(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let s=new W,r=new W,o=new W,a=new W,l=new W,c=new W,h=new W,u=new W;if(t)for(let f=0,d=t.count;f<d;f+=3){let g=t.getX(f+0),x=t.getX(f+1),m=t.getX(f+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(f+0,h.x,h.y,h.z),n.setXYZ(f+1,h.x,h.y,h.z),n.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Cn.fromBufferAttribute(t,e),Cn.normalize(),t.setXYZ(e,Cn.x,Cn.y,Cn.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h),d=0,g=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?d=l[x]*a.data.stride+a.offset:d=l[x]*h;for(let p=0;p<h;p++)f[g++]=c[d++]}return new Ve(f,h,u)}if(this.index===null)return Yt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let f=c[h],d=t(f,n);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let d=c[u];h.push(d.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let f=0,d=u.length;f<d;f++)h.push(u[f].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var zu=new W,Ey=new W,Ty=new ne,di=class{constructor(t=new W(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=zu.subVectors(n,e).cross(Ey.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(zu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Ty.getNormalMatrix(t),s=this.coplanarPoint(zu).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Ay=0,xs=class extends Di{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Ay++}),this.uuid=vo(),this.name="",this.type="Material",this.blending=go,this.side=$s,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=nf,this.blendDst=sf,this.blendEquation=mr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new pe(0,0,0),this.blendAlpha=0,this.depthFunc=ro,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=mg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ol,this.stencilZFail=Ol,this.stencilZPass=Ol,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Yt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Yt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new pe().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new di().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new re().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new re().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var ps=new W,Vu=new W,gl=new W,_l=new W,Vs=class{constructor(t=new W,e=new W(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,ps)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=ps.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(ps.copy(this.origin).addScaledVector(this.direction,e),ps.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Vu.copy(t).add(e).multiplyScalar(.5),gl.copy(e).sub(t).normalize(),_l.copy(this.origin).sub(Vu);let r=t.distanceTo(e)*.5,o=-this.direction.dot(gl),a=_l.dot(this.direction),l=-_l.dot(gl),c=_l.lengthSq(),h=Math.abs(1-o*o),u,f,d,g;if(h>0)if(u=o*l-a,f=o*a-l,g=r*h,u>=0)if(f>=-g)if(f<=g){let x=1/h;u*=x,f*=x,d=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f<=-g?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c):f<=g?(u=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Vu).addScaledVector(gl,f),d}intersectSphere(t,e){if(t.radius<0)return null;ps.subVectors(t.center,this.origin);let n=ps.dot(this.direction),s=ps.dot(ps)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),h>=0?(r=(t.min.y-f.y)*h,o=(t.max.y-f.y)*h):(r=(t.max.y-f.y)*h,o=(t.min.y-f.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-f.z)*u,l=(t.max.z-f.z)*u):(a=(t.max.z-f.z)*u,l=(t.min.z-f.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,ps)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,f=t.y-o.y,d=t.z-o.z,g=e.x-o.x,x=e.y-o.y,m=e.z-o.z,p=n.x-o.x,v=n.y-o.y,A=n.z-o.z,M=Math.abs(l),C=Math.abs(c),S=Math.abs(h),_,E,U,D,L,B,F,I,z,X,V,ot;if(M>=C&&M>=S?(U=l,B=u,z=g,ot=p,l>=0?(_=c,E=h,D=f,L=d,F=x,I=m,X=v,V=A):(_=h,E=c,D=d,L=f,F=m,I=x,X=A,V=v)):C>=S?(U=c,B=f,z=x,ot=v,c>=0?(_=h,E=l,D=d,L=u,F=m,I=g,X=A,V=p):(_=l,E=h,D=u,L=d,F=g,I=m,X=p,V=A)):(U=h,B=d,z=m,ot=A,h>=0?(_=l,E=c,D=u,L=f,F=g,I=x,X=p,V=v):(_=c,E=l,D=f,L=u,F=x,I=g,X=v,V=p)),U===0)return null;let q=_/U,j=E/U,tt=1/U,lt=D-q*B,it=L-j*B,Z=F-q*z,ft=I-j*z,dt=X-q*ot,Mt=V-j*ot,gt=dt*ft-Mt*Z,kt=lt*Mt-it*dt,Wt=Z*it-ft*lt;if(s){if(gt<0||kt<0||Wt<0)return null}else if((gt<0||kt<0||Wt<0)&&(gt>0||kt>0||Wt>0))return null;let Nt=gt+kt+Wt;if(Nt===0)return null;let ee=tt*(gt*B+kt*z+Wt*ot);return(Nt>0?ee<0:ee>0)?null:this.at(ee/Nt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Zi=class extends xs{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new pe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ks,this.combine=rf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Cm=new Je,ur=new Vs,xl=new zs,Rm=new W,yl=new W,vl=new W,Ml=new W,Gu=new W,bl=new W,Pm=new W,Sl=new W,tn=class extends $n{constructor(t=new Oe,e=new Zi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){bl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Gu.fromBufferAttribute(u,t),o?bl.addScaledVector(Gu,h):bl.addScaledVector(Gu.sub(e),h))}e.add(bl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),xl.copy(n.boundingSphere),xl.applyMatrix4(r),ur.copy(t.ray).recast(t.near),!(xl.containsPoint(ur.origin)===!1&&(ur.intersectSphere(xl,Rm)===null||ur.origin.distanceToSquared(Rm)>(t.far-t.near)**2))&&(Cm.copy(r).invert(),ur.copy(t.ray).applyMatrix4(Cm),!(n.boundingBox!==null&&ur.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,ur)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,x=f.length;g<x;g++){let m=f[g],p=o[m.materialIndex],v=Math.max(m.start,d.start),A=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let M=v,C=A;M<C;M+=3){let S=a.getX(M),_=a.getX(M+1),E=a.getX(M+2);s=wl(this,p,t,n,c,h,u,S,_,E),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),x=Math.min(a.count,d.start+d.count);for(let m=g,p=x;m<p;m+=3){let v=a.getX(m),A=a.getX(m+1),M=a.getX(m+2);s=wl(this,o,t,n,c,h,u,v,A,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,x=f.length;g<x;g++){let m=f[g],p=o[m.materialIndex],v=Math.max(m.start,d.start),A=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let M=v,C=A;M<C;M+=3){let S=M,_=M+1,E=M+2;s=wl(this,p,t,n,c,h,u,S,_,E),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),x=Math.min(l.count,d.start+d.count);for(let m=g,p=x;m<p;m+=3){let v=m,A=m+1,M=m+2;s=wl(this,o,t,n,c,h,u,v,A,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Cy(i,t,e,n,s,r,o,a){let l;if(t.side===Zn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===$s,a),l===null)return null;Sl.copy(a),Sl.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Sl);return c<e.near||c>e.far?null:{distance:c,point:Sl.clone(),object:i}}function wl(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,yl),i.getVertexPosition(l,vl),i.getVertexPosition(c,Ml);let h=Cy(i,t,e,n,yl,vl,Ml,Pm);if(h){let u=new W;ms.getBarycoord(Pm,yl,vl,Ml,u),s&&(h.uv=ms.getInterpolatedAttribute(s,a,l,c,u,new re)),r&&(h.uv1=ms.getInterpolatedAttribute(r,a,l,c,u,new re)),o&&(h.normal=ms.getInterpolatedAttribute(o,a,l,c,u,new W),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new W,materialIndex:0};ms.getNormal(yl,vl,Ml,f.normal),h.face=f,h.barycoord=u}return h}var ho=class extends jn{constructor(t=null,e=1,n=1,s,r,o,a,l,c=Rn,h=Rn,u,f){super(null,o,a,l,c,h,s,r,u,f),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var fr=new zs,Ry=new re(.5,.5),El=new W,dr=class{constructor(t=new di,e=new di,n=new di,s=new di,r=new di,o=new di){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Si,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],f=r[6],d=r[7],g=r[8],x=r[9],m=r[10],p=r[11],v=r[12],A=r[13],M=r[14],C=r[15];if(s[0].setComponents(c-o,d-h,p-g,C-v).normalize(),s[1].setComponents(c+o,d+h,p+g,C+v).normalize(),s[2].setComponents(c+a,d+u,p+x,C+A).normalize(),s[3].setComponents(c-a,d-u,p-x,C-A).normalize(),n)s[4].setComponents(l,f,m,M).normalize(),s[5].setComponents(c-l,d-f,p-m,C-M).normalize();else if(s[4].setComponents(c-l,d-f,p-m,C-M).normalize(),e===Si)s[5].setComponents(c+l,d+f,p+m,C+M).normalize();else if(e===ea)s[5].setComponents(l,f,m,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),fr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),fr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(fr)}intersectsSprite(t){fr.center.set(0,0,0);let e=Ry.distanceTo(t.center);return fr.radius=.7071067811865476+e,fr.applyMatrix4(t.matrixWorld),this.intersectsSphere(fr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(El.x=s.normal.x>0?t.max.x:t.min.x,El.y=s.normal.y>0?t.max.y:t.min.y,El.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(El)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Im=new Je,Kl=class i{constructor(){this.coordinateSystem=Si,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Im.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new dr),n[s].setFromProjectionMatrix(Im,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new dr),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var Ji=class extends xs{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new pe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},jl=new W,Ql=new W,Lm=new Je,Zo=new Vs,Tl=new zs,Hu=new W,Dm=new W,tc=class extends $n{constructor(t=new Oe,e=new Ji){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)jl.fromBufferAttribute(e,s-1),Ql.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=jl.distanceTo(Ql);t.setAttribute("lineDistance",new Ge(n,1))}else Yt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Tl.copy(n.boundingSphere),Tl.applyMatrix4(s),Tl.radius+=r,t.ray.intersectsSphere(Tl)===!1)return;Lm.copy(s).invert(),Zo.copy(t.ray).applyMatrix4(Lm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,f=n.attributes.position;if(h!==null){let d=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let x=d,m=g-1;x<m;x+=c){let p=h.getX(x),v=h.getX(x+1),A=Al(this,t,Zo,l,p,v,x);A&&e.push(A)}if(this.isLineLoop){let x=h.getX(g-1),m=h.getX(d),p=Al(this,t,Zo,l,x,m,g-1);p&&e.push(p)}}else{let d=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let x=d,m=g-1;x<m;x+=c){let p=Al(this,t,Zo,l,x,x+1,x);p&&e.push(p)}if(this.isLineLoop){let x=Al(this,t,Zo,l,g-1,d,g-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Al(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(jl.fromBufferAttribute(a,s),Ql.fromBufferAttribute(a,r),e.distanceSqToSegment(jl,Ql,Hu,Dm)>n)return;Hu.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Hu);if(!(c<t.near||c>t.far))return{distance:c,point:Dm.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Nm=new W,Um=new W,ys=class extends tc{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)Nm.fromBufferAttribute(e,s),Um.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Nm.distanceTo(Um);t.setAttribute("lineDistance",new Ge(n,1))}else Yt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ec=class extends xs{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new pe(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Fm=new Je,Zu=new Vs,Cl=new zs,Rl=new W,la=class extends $n{constructor(t=new Oe,e=new ec){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Cl.copy(n.boundingSphere),Cl.applyMatrix4(s),Cl.radius+=r,t.ray.intersectsSphere(Cl)===!1)return;Fm.copy(s).invert(),Zu.copy(t.ray).applyMatrix4(Fm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){let f=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let g=f,x=d;g<x;g++){let m=c.getX(g);Rl.fromBufferAttribute(u,m),Om(Rl,m,l,s,t,e,this)}}else{let f=Math.max(0,o.start),d=Math.min(u.count,o.start+o.count);for(let g=f,x=d;g<x;g++)Rl.fromBufferAttribute(u,g),Om(Rl,g,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Om(i,t,e,n,s,r,o){let a=Zu.distanceSqToPoint(i);if(a<e){let l=new W;Zu.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var ca=class extends jn{constructor(t=[],e=gr,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var vs=class extends jn{constructor(t,e,n=_i,s,r,o,a=Rn,l=Rn,c,h=_s,u=1){if(h!==_s&&h!==bs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:u};super(f,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new lo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ha=class extends vs{constructor(t,e=_i,n=gr,s,r,o=Rn,a=Rn,l,c=_s){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},ua=class extends jn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Gs=class i extends Oe{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],f=0,d=0;g("z","y","x",-1,-1,n,e,t,o,r,0),g("z","y","x",1,-1,n,e,-t,o,r,1),g("x","z","y",1,1,t,n,e,s,o,2),g("x","z","y",1,-1,t,n,-e,s,o,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Ge(c,3)),this.setAttribute("normal",new Ge(h,3)),this.setAttribute("uv",new Ge(u,2));function g(x,m,p,v,A,M,C,S,_,E,U){let D=M/_,L=C/E,B=M/2,F=C/2,I=S/2,z=_+1,X=E+1,V=0,ot=0,q=new W;for(let j=0;j<X;j++){let tt=j*L-F;for(let lt=0;lt<z;lt++){let it=lt*D-B;q[x]=it*v,q[m]=tt*A,q[p]=I,c.push(q.x,q.y,q.z),q[x]=0,q[m]=0,q[p]=S>0?1:-1,h.push(q.x,q.y,q.z),u.push(lt/_),u.push(1-j/E),V+=1}}for(let j=0;j<E;j++)for(let tt=0;tt<_;tt++){let lt=f+tt+z*j,it=f+tt+z*(j+1),Z=f+(tt+1)+z*(j+1),ft=f+(tt+1)+z*j;l.push(lt,it,ft),l.push(it,Z,ft),ot+=6}a.addGroup(d,ot,U),d+=ot,f+=V}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Pl=new W,Il=new W,Wu=new W,Ll=new ms,uo=class extends Oe{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(io*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),f=new Map,d=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);let{a:x,b:m,c:p}=Ll;if(x.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),p.fromBufferAttribute(a,c[2]),Ll.getNormal(Wu),u[0]=`${Math.round(x.x*s)},${Math.round(x.y*s)},${Math.round(x.z*s)}`,u[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,u[2]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let v=0;v<3;v++){let A=(v+1)%3,M=u[v],C=u[A],S=Ll[h[v]],_=Ll[h[A]],E=`${M}_${C}`,U=`${C}_${M}`,D=f.get(U);D?(Wu.dot(D.normal)<=r&&(d.push(S.x,S.y,S.z),d.push(_.x,_.y,_.z)),f.set(U,null)):f.has(E)||f.set(E,{index0:c[v],index1:c[A],normal:Wu.clone()})}}for(let g of f.values())if(g){let{index0:x,index1:m}=g;Pl.fromBufferAttribute(a,x),Il.fromBufferAttribute(a,m),d.push(Pl.x,Pl.y,Pl.z),d.push(Il.x,Il.y,Il.z)}this.setAttribute("position",new Ge(d,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var fa=class i extends Oe{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,f=e/l,d=[],g=[],x=[],m=[];for(let p=0;p<h;p++){let v=p*f-o;for(let A=0;A<c;A++){let M=A*u-r;g.push(M,-v,0),x.push(0,0,1),m.push(A/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let v=0;v<a;v++){let A=v+c*p,M=v+c*(p+1),C=v+1+c*(p+1),S=v+1+c*p;d.push(A,M,S),d.push(M,C,S)}this.setIndex(d),this.setAttribute("position",new Ge(g,3)),this.setAttribute("normal",new Ge(x,3)),this.setAttribute("uv",new Ge(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var da=class i extends Oe{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new W,f=new W,d=[],g=[],x=[],m=[];for(let p=0;p<=n;p++){let v=[],A=p/n,M=o+A*a,C=t*Math.cos(M),S=Math.sqrt(t*t-C*C),_=0;p===0&&o===0?_=.5/e:p===n&&l===Math.PI&&(_=-.5/e);for(let E=0;E<=e;E++){let U=E/e,D=s+U*r;u.x=-S*Math.cos(D),u.y=C,u.z=S*Math.sin(D),g.push(u.x,u.y,u.z),f.copy(u).normalize(),x.push(f.x,f.y,f.z),m.push(U+_,1-A),v.push(c++)}h.push(v)}for(let p=0;p<n;p++)for(let v=0;v<e;v++){let A=h[p][v+1],M=h[p][v],C=h[p+1][v],S=h[p+1][v+1];(p!==0||o>0)&&d.push(A,M,S),(p!==n-1||l<Math.PI)&&d.push(M,C,S)}this.setIndex(d),this.setAttribute("position",new Ge(g,3)),this.setAttribute("normal",new Ge(x,3)),this.setAttribute("uv",new Ge(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function xr(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(Bm(s))s.isRenderTargetTexture?(Yt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Bm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function On(i){let t={};for(let e=0;e<i.length;e++){let n=xr(i[e]);for(let s in n)t[s]=n[s]}return t}function Bm(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Py(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function If(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ye.workingColorSpace}var Rg={clone:xr,merge:On},Iy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Ly=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Pn=class extends xs{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Iy,this.fragmentShader=Ly,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=xr(t.uniforms),this.uniformsGroups=Py(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new pe().setHex(s.value);break;case"v2":this.uniforms[n].value=new re().fromArray(s.value);break;case"v3":this.uniforms[n].value=new W().fromArray(s.value);break;case"v4":this.uniforms[n].value=new De().fromArray(s.value);break;case"m3":this.uniforms[n].value=new ne().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Je().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},nc=class extends Pn{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var ic=class extends xs{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=dg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},sc=class extends xs{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function to(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function Dl(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Hs=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},rc=class extends Hs{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:qu,endingEnd:qu}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Yu:r=t,a=2*e-n;break;case $u:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Yu:o=t,l=2*n-e;break;case $u:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,f=this._weightPrev,d=this._weightNext,g=(n-e)/(s-e),x=g*g,m=x*g,p=-f*m+2*f*x-f*g,v=(1+f)*m+(-1.5-2*f)*x+(-.5+f)*g+1,A=(-1-d)*m+(1.5+d)*x+.5*g,M=d*m-d*x;for(let C=0;C!==a;++C)r[C]=p*o[h+C]+v*o[c+C]+A*o[l+C]+M*o[u+C];return r}},oc=class extends Hs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),u=1-h;for(let f=0;f!==a;++f)r[f]=o[c+f]*u+o[l+f]*h;return r}},ac=class extends Hs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},lc=class extends Hs{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(n-e)/(s-e),x=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*x+o[l+m]*g;return r}let f=a*2,d=t-1;for(let g=0;g!==a;++g){let x=o[c+g],m=o[l+g],p=d*f+g*2,v=u[p],A=u[p+1],M=t*f+g*2,C=h[M],S=h[M+1],_=Ny(n,e,v,C,s);r[g]=Pg(_,x,A,S,m)}return r}};function Pg(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function Dy(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function Ny(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=Pg(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=Dy(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var mi=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=to(e,this.TimeBufferType),this.values=to(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:to(t.times,Array),values:to(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),Dl(t.settings)&&(n.settings={inTangents:to(t.settings.inTangents,Array),outTangents:to(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new ac(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new oc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new rc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new lc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case jo:e=this.InterpolantFactoryMethodDiscrete;break;case Yl:e=this.InterpolantFactoryMethodLinear;break;case Fl:e=this.InterpolantFactoryMethodSmooth;break;case Xu:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Yt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return jo;case this.InterpolantFactoryMethodLinear:return Yl;case this.InterpolantFactoryMethodSmooth:return Fl;case this.InterpolantFactoryMethodBezier:return Xu}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;Dl(this.settings)&&(km(this.settings.inTangents,t),km(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;Dl(this.settings)&&(zm(this.settings.inTangents,t),zm(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(te("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(te("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){te("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){te("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Jx(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){te("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Fl,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*n,f=u-n,d=u+n;for(let g=0;g!==n;++g){let x=e[u+g];if(x!==e[f+g]||x!==e[d+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*n,f=o*n;for(let d=0;d!==n;++d)e[f+d]=e[u+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,Dl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function km(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function zm(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}mi.prototype.ValueTypeName="";mi.prototype.TimeBufferType=Float32Array;mi.prototype.ValueBufferType=Float32Array;mi.prototype.DefaultInterpolation=Yl;var Ws=class extends mi{constructor(t,e,n){super(t,e,n)}};Ws.prototype.ValueTypeName="bool";Ws.prototype.ValueBufferType=Array;Ws.prototype.DefaultInterpolation=jo;Ws.prototype.InterpolantFactoryMethodLinear=void 0;Ws.prototype.InterpolantFactoryMethodSmooth=void 0;var cc=class extends mi{constructor(t,e,n,s){super(t,e,n,s)}};cc.prototype.ValueTypeName="color";var hc=class extends mi{constructor(t,e,n,s){super(t,e,n,s)}};hc.prototype.ValueTypeName="number";var uc=class extends Hs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)Yn.slerpFlat(r,0,o,c-a,o,c,l);return r}},pa=class extends mi{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new uc(this.times,this.values,this.getValueSize(),t)}};pa.prototype.ValueTypeName="quaternion";pa.prototype.InterpolantFactoryMethodSmooth=void 0;var Xs=class extends mi{constructor(t,e,n){super(t,e,n)}};Xs.prototype.ValueTypeName="string";Xs.prototype.ValueBufferType=Array;Xs.prototype.DefaultInterpolation=jo;Xs.prototype.InterpolantFactoryMethodLinear=void 0;Xs.prototype.InterpolantFactoryMethodSmooth=void 0;var fc=class extends mi{constructor(t,e,n,s){super(t,e,n,s)}};fc.prototype.ValueTypeName="vector";var dc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=c.length;u<f;u+=2){let d=c[u],g=c[u+1];if(d.global&&(d.lastIndex=0),d.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Ig=new dc,pc=class{constructor(t){this.manager=t!==void 0?t:Ig,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};pc.DEFAULT_MATERIAL_NAME="__DEFAULT";var mc=class extends $n{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new pe(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var Nl=new W,Ul=new Yn,Yi=new W,ma=class extends $n{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Je,this.projectionMatrix=new Je,this.projectionMatrixInverse=new Je,this.coordinateSystem=Si,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Nl,Ul,Yi),Yi.x===1&&Yi.y===1&&Yi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Nl,Ul,Yi.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(Nl,Ul,Yi),Yi.x===1&&Yi.y===1&&Yi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Nl,Ul,Yi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Bs=new W,Vm=new re,Gm=new re,Xn=class extends ma{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=ao*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(io*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return ao*2*Math.atan(Math.tan(io*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Bs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Bs.x,Bs.y).multiplyScalar(-t/Bs.z),Bs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Bs.x,Bs.y).multiplyScalar(-t/Bs.z)}getViewSize(t,e){return this.getViewBounds(t,Vm,Gm),e.subVectors(Gm,Vm)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(io*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var gc=class extends ma{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var ga=class extends mc{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var eo=-90,no=1,fo=class extends $n{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Xn(eo,no,t,e);s.layers=this.layers,this.add(s);let r=new Xn(eo,no,t,e);r.layers=this.layers,this.add(r);let o=new Xn(eo,no,t,e);o.layers=this.layers,this.add(o);let a=new Xn(eo,no,t,e);a.layers=this.layers,this.add(a);let l=new Xn(eo,no,t,e);l.layers=this.layers,this.add(l);let c=new Xn(eo,no,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Si)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===ea)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=x,t.setRenderTarget(n,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,f,d),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},_c=class extends Xn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Lf="\\[\\]\\.:\\/",Uy=new RegExp("["+Lf+"]","g"),Df="[^"+Lf+"]",Fy="[^"+Lf.replace("\\.","")+"]",Oy=/((?:WC+[\/:])*)/.source.replace("WC",Df),By=/(WCOD+)?/.source.replace("WCOD",Fy),ky=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Df),zy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Df),Vy=new RegExp("^"+Oy+By+ky+zy+"$"),Gy=["material","materials","bones","map"],Ju=class{constructor(t,e,n){let s=n||$e.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},$e=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Uy,"")}static parseTrackName(t){let e=Vy.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Gy.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Yt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){te("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){te("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){te("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){te("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){te("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){te("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){te("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;te("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){te("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){te("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};$e.Composite=Ju;$e.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};$e.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};$e.prototype.GetterByBindingType=[$e.prototype._getValue_direct,$e.prototype._getValue_array,$e.prototype._getValue_arrayElement,$e.prototype._getValue_toArray];$e.prototype.SetterByBindingTypeAndVersioning=[[$e.prototype._setValue_direct,$e.prototype._setValue_direct_setNeedsUpdate,$e.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[$e.prototype._setValue_array,$e.prototype._setValue_array_setNeedsUpdate,$e.prototype._setValue_array_setMatrixWorldNeedsUpdate],[$e.prototype._setValue_arrayElement,$e.prototype._setValue_arrayElement_setNeedsUpdate,$e.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[$e.prototype._setValue_fromArray,$e.prototype._setValue_fromArray_setNeedsUpdate,$e.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var tE=new Float32Array(1);var po=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=de(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(de(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Ku=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var _a=class extends ys{constructor(t=10,e=10,n=4473924,s=8947848){n=new pe(n),s=new pe(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let f=0,d=0,g=-a;f<=e;f++,g+=o){l.push(-a,0,g,a,0,g),l.push(g,0,-a,g,0,a);let x=f===r?n:s;x.toArray(c,d),d+=3,x.toArray(c,d),d+=3,x.toArray(c,d),d+=3,x.toArray(c,d),d+=3}let h=new Oe;h.setAttribute("position",new Ge(l,3)),h.setAttribute("color",new Ge(c,3));let u=new Ji({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var xa=class extends Di{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Nf(i,t,e,n){let s=Hy(n);switch(e){case xf:return i*t;case vf:return i*t/s.components*s.byteLength;case yo:return i*t/s.components*s.byteLength;case Zs:return i*t*2/s.components*s.byteLength;case wc:return i*t*2/s.components*s.byteLength;case yf:return i*t*3/s.components*s.byteLength;case Fi:return i*t*4/s.components*s.byteLength;case Ec:return i*t*4/s.components*s.byteLength;case Ma:case ba:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Sa:case wa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Ac:case Rc:return Math.max(i,16)*Math.max(t,8)/4;case Tc:case Cc:return Math.max(i,8)*Math.max(t,8)/2;case Pc:case Ic:case Dc:case Nc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Lc:case Ea:case Uc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Fc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Oc:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Bc:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case kc:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case zc:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Vc:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Gc:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Hc:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Wc:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Xc:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case qc:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Yc:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case $c:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Zc:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Jc:case Kc:case jc:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Qc:case th:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Ta:case eh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Hy(i){switch(i){case gi:case pf:return{byteLength:1,components:1};case xo:case mf:case Ui:return{byteLength:2,components:1};case bc:case Sc:return{byteLength:2,components:4};case _i:case Mc:case Ni:return{byteLength:4,components:1};case gf:case _f:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Yt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Qg(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function Xy(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,h),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((d,g)=>d.start-g.start);let f=0;for(let d=1;d<u.length;d++){let g=u[f],x=u[d];x.start<=g.start+g.count+1?g.count=Math.max(g.count,x.start+x.count-g.start):(++f,u[f]=x)}u.length=f+1;for(let d=0,g=u.length;d<g;d++){let x=u[d];i.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var qy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Yy=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,$y=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Zy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Jy=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Ky=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,jy=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Qy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,tv=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,ev=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,nv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,iv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,sv=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,rv=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,ov=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,av=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,lv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,cv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,hv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,uv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,fv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,dv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,pv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,mv=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,gv=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,_v=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,xv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,yv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,vv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Mv="gl_FragColor = linearToOutputTexel( gl_FragColor );",bv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Sv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,wv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Ev=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Tv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Av=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Cv=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Rv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Pv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Iv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Lv=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Dv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Nv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Uv=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Fv=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Ov=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Bv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,kv=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,zv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Vv=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Gv=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Hv=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Wv=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Xv=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,qv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Yv=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,$v=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Zv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Jv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Kv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,jv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Qv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,tM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,eM=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,nM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,iM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,sM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,rM=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,oM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,aM=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,lM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,cM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,hM=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,uM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,fM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,dM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,pM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,mM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,gM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,_M=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,xM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,yM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,vM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,MM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,bM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,SM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,wM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,EM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,TM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,AM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,CM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,RM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,PM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,IM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,LM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,DM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,NM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,UM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,FM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,OM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,BM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,kM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,zM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,VM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,GM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,HM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,WM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,XM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,qM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,YM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,$M=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ZM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,JM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,KM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,jM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,QM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,tb=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,eb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,nb=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ib=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,sb=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,rb=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,ob=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ab=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,lb=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,cb=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,hb=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ub=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,fb=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,db=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,pb=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,mb=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,gb=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,_b=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,xb=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,yb=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,vb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Mb=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,bb=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Sb=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,wb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ce={alphahash_fragment:qy,alphahash_pars_fragment:Yy,alphamap_fragment:$y,alphamap_pars_fragment:Zy,alphatest_fragment:Jy,alphatest_pars_fragment:Ky,aomap_fragment:jy,aomap_pars_fragment:Qy,batching_pars_vertex:tv,batching_vertex:ev,begin_vertex:nv,beginnormal_vertex:iv,bsdfs:sv,iridescence_fragment:rv,bumpmap_pars_fragment:ov,clipping_planes_fragment:av,clipping_planes_pars_fragment:lv,clipping_planes_pars_vertex:cv,clipping_planes_vertex:hv,color_fragment:uv,color_pars_fragment:fv,color_pars_vertex:dv,color_vertex:pv,common:mv,defaultnormal_vertex:gv,displacementmap_pars_vertex:_v,displacementmap_vertex:xv,emissivemap_fragment:yv,emissivemap_pars_fragment:vv,colorspace_fragment:Mv,colorspace_pars_fragment:bv,envmap_fragment:Sv,envmap_common_pars_fragment:wv,envmap_pars_fragment:Ev,envmap_pars_vertex:Tv,envmap_physical_pars_fragment:Ov,envmap_vertex:Av,fog_vertex:Cv,fog_pars_vertex:Rv,fog_fragment:Pv,fog_pars_fragment:Iv,gradientmap_pars_fragment:Lv,lightmap_pars_fragment:Dv,lights_lambert_fragment:Nv,lights_lambert_pars_fragment:Uv,lights_pars_begin:Fv,lights_toon_fragment:Bv,lights_toon_pars_fragment:kv,lights_phong_fragment:zv,lights_phong_pars_fragment:Vv,lights_physical_fragment:Gv,lights_physical_pars_fragment:Hv,lights_fragment_begin:Wv,lights_fragment_maps:Xv,lights_fragment_end:qv,lightprobes_pars_fragment:Yv,logdepthbuf_fragment:$v,logdepthbuf_pars_fragment:Zv,logdepthbuf_pars_vertex:Jv,logdepthbuf_vertex:Kv,map_fragment:jv,map_pars_fragment:Qv,map_particle_fragment:tM,map_particle_pars_fragment:eM,metalnessmap_fragment:nM,metalnessmap_pars_fragment:iM,morphinstance_vertex:sM,morphcolor_vertex:rM,morphnormal_vertex:oM,morphtarget_pars_vertex:aM,morphtarget_vertex:lM,normal_fragment_begin:cM,normal_fragment_maps:hM,normal_pars_fragment:uM,normal_pars_vertex:fM,normal_vertex:dM,normalmap_pars_fragment:pM,clearcoat_normal_fragment_begin:mM,clearcoat_normal_fragment_maps:gM,clearcoat_pars_fragment:_M,iridescence_pars_fragment:xM,opaque_fragment:yM,packing:vM,premultiplied_alpha_fragment:MM,project_vertex:bM,dithering_fragment:SM,dithering_pars_fragment:wM,roughnessmap_fragment:EM,roughnessmap_pars_fragment:TM,shadowmap_pars_fragment:AM,shadowmap_pars_vertex:CM,shadowmap_vertex:RM,shadowmask_pars_fragment:PM,skinbase_vertex:IM,skinning_pars_vertex:LM,skinning_vertex:DM,skinnormal_vertex:NM,specularmap_fragment:UM,specularmap_pars_fragment:FM,tonemapping_fragment:OM,tonemapping_pars_fragment:BM,transmission_fragment:kM,transmission_pars_fragment:zM,uv_pars_fragment:VM,uv_pars_vertex:GM,uv_vertex:HM,worldpos_vertex:WM,background_vert:XM,background_frag:qM,backgroundCube_vert:YM,backgroundCube_frag:$M,cube_vert:ZM,cube_frag:JM,depth_vert:KM,depth_frag:jM,distance_vert:QM,distance_frag:tb,equirect_vert:eb,equirect_frag:nb,linedashed_vert:ib,linedashed_frag:sb,meshbasic_vert:rb,meshbasic_frag:ob,meshlambert_vert:ab,meshlambert_frag:lb,meshmatcap_vert:cb,meshmatcap_frag:hb,meshnormal_vert:ub,meshnormal_frag:fb,meshphong_vert:db,meshphong_frag:pb,meshphysical_vert:mb,meshphysical_frag:gb,meshtoon_vert:_b,meshtoon_frag:xb,points_vert:yb,points_frag:vb,shadow_vert:Mb,shadow_frag:bb,sprite_vert:Sb,sprite_frag:wb},It={common:{diffuse:{value:new pe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ne},alphaMap:{value:null},alphaMapTransform:{value:new ne},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ne}},envmap:{envMap:{value:null},envMapRotation:{value:new ne},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ne}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ne}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ne},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ne},normalScale:{value:new re(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ne},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ne}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ne}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ne}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new pe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new pe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ne},alphaTest:{value:0},uvTransform:{value:new ne}},sprite:{diffuse:{value:new pe(16777215)},opacity:{value:1},center:{value:new re(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ne},alphaMap:{value:null},alphaMapTransform:{value:new ne},alphaTest:{value:0}}},Qi={basic:{uniforms:On([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.fog]),vertexShader:ce.meshbasic_vert,fragmentShader:ce.meshbasic_frag},lambert:{uniforms:On([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.fog,It.lights,{emissive:{value:new pe(0)},envMapIntensity:{value:1}}]),vertexShader:ce.meshlambert_vert,fragmentShader:ce.meshlambert_frag},phong:{uniforms:On([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.fog,It.lights,{emissive:{value:new pe(0)},specular:{value:new pe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ce.meshphong_vert,fragmentShader:ce.meshphong_frag},standard:{uniforms:On([It.common,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.roughnessmap,It.metalnessmap,It.fog,It.lights,{emissive:{value:new pe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ce.meshphysical_vert,fragmentShader:ce.meshphysical_frag},toon:{uniforms:On([It.common,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.gradientmap,It.fog,It.lights,{emissive:{value:new pe(0)}}]),vertexShader:ce.meshtoon_vert,fragmentShader:ce.meshtoon_frag},matcap:{uniforms:On([It.common,It.bumpmap,It.normalmap,It.displacementmap,It.fog,{matcap:{value:null}}]),vertexShader:ce.meshmatcap_vert,fragmentShader:ce.meshmatcap_frag},points:{uniforms:On([It.points,It.fog]),vertexShader:ce.points_vert,fragmentShader:ce.points_frag},dashed:{uniforms:On([It.common,It.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ce.linedashed_vert,fragmentShader:ce.linedashed_frag},depth:{uniforms:On([It.common,It.displacementmap]),vertexShader:ce.depth_vert,fragmentShader:ce.depth_frag},normal:{uniforms:On([It.common,It.bumpmap,It.normalmap,It.displacementmap,{opacity:{value:1}}]),vertexShader:ce.meshnormal_vert,fragmentShader:ce.meshnormal_frag},sprite:{uniforms:On([It.sprite,It.fog]),vertexShader:ce.sprite_vert,fragmentShader:ce.sprite_frag},background:{uniforms:{uvTransform:{value:new ne},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ce.background_vert,fragmentShader:ce.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ne}},vertexShader:ce.backgroundCube_vert,fragmentShader:ce.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ce.cube_vert,fragmentShader:ce.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ce.equirect_vert,fragmentShader:ce.equirect_frag},distance:{uniforms:On([It.common,It.displacementmap,{referencePosition:{value:new W},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ce.distance_vert,fragmentShader:ce.distance_frag},shadow:{uniforms:On([It.lights,It.fog,{color:{value:new pe(0)},opacity:{value:1}}]),vertexShader:ce.shadow_vert,fragmentShader:ce.shadow_frag}};Qi.physical={uniforms:On([Qi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ne},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ne},clearcoatNormalScale:{value:new re(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ne},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ne},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ne},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ne},sheen:{value:0},sheenColor:{value:new pe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ne},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ne},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ne},transmissionSamplerSize:{value:new re},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ne},attenuationDistance:{value:0},attenuationColor:{value:new pe(0)},specularColor:{value:new pe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ne},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ne},anisotropyVector:{value:new re},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ne}}]),vertexShader:ce.meshphysical_vert,fragmentShader:ce.meshphysical_frag};var nh={r:0,b:0,g:0},Eb=new Je,t0=new ne;t0.set(-1,0,0,0,1,0,0,0,1);function Tb(i,t,e,n,s,r){let o=new pe(0),a=s===!0?0:1,l,c,h=null,u=0,f=null;function d(v){let A=v.isScene===!0?v.background:null;if(A&&A.isTexture){let M=v.backgroundBlurriness>0;A=t.get(A,M)}return A}function g(v){let A=!1,M=d(v);M===null?m(o,a):M&&M.isColor&&(m(M,1),A=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function x(v,A){let M=d(A);M&&M.isCubeTexture?(c===void 0&&(c=new tn(new Gs(1,1,1),new Pn({name:"BackgroundCubeMaterial",uniforms:xr(Qi.backgroundCube.uniforms),vertexShader:Qi.backgroundCube.vertexShader,fragmentShader:Qi.backgroundCube.fragmentShader,side:Zn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,S,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Eb.makeRotationFromEuler(A.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(t0),c.material.toneMapped=ye.getTransfer(M.colorSpace)!==Re,(h!==M||u!==M.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,h=M,u=M.version,f=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new tn(new fa(2,2),new Pn({name:"BackgroundMaterial",uniforms:xr(Qi.background.uniforms),vertexShader:Qi.background.vertexShader,fragmentShader:Qi.background.fragmentShader,side:$s,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=ye.getTransfer(M.colorSpace)!==Re,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||u!==M.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,h=M,u=M.version,f=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function m(v,A){v.getRGB(nh,If(i)),e.buffers.color.setClear(nh.r,nh.g,nh.b,A,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,A=1){o.set(v),a=A,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,m(o,a)},render:g,addToRenderList:x,dispose:p}}function Ab(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(L,B,F,I,z){let X=!1,V=u(L,I,F,B);r!==V&&(r=V,c(r.object)),X=d(L,I,F,z),X&&g(L,I,F,z),z!==null&&t.update(z,i.ELEMENT_ARRAY_BUFFER),(X||o)&&(o=!1,M(L,B,F,I),z!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(z).buffer))}function l(){return i.createVertexArray()}function c(L){return i.bindVertexArray(L)}function h(L){return i.deleteVertexArray(L)}function u(L,B,F,I){let z=I.wireframe===!0,X=n[B.id];X===void 0&&(X={},n[B.id]=X);let V=L.isInstancedMesh===!0?L.id:0,ot=X[V];ot===void 0&&(ot={},X[V]=ot);let q=ot[F.id];q===void 0&&(q={},ot[F.id]=q);let j=q[z];return j===void 0&&(j=f(l()),q[z]=j),j}function f(L){let B=[],F=[],I=[];for(let z=0;z<e;z++)B[z]=0,F[z]=0,I[z]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:F,attributeDivisors:I,object:L,attributes:{},index:null}}function d(L,B,F,I){let z=r.attributes,X=B.attributes,V=0,ot=F.getAttributes();for(let q in ot)if(ot[q].location>=0){let tt=z[q],lt=X[q];if(lt===void 0&&(q==="instanceMatrix"&&L.instanceMatrix&&(lt=L.instanceMatrix),q==="instanceColor"&&L.instanceColor&&(lt=L.instanceColor)),tt===void 0||tt.attribute!==lt||lt&&tt.data!==lt.data)return!0;V++}return r.attributesNum!==V||r.index!==I}function g(L,B,F,I){let z={},X=B.attributes,V=0,ot=F.getAttributes();for(let q in ot)if(ot[q].location>=0){let tt=X[q];tt===void 0&&(q==="instanceMatrix"&&L.instanceMatrix&&(tt=L.instanceMatrix),q==="instanceColor"&&L.instanceColor&&(tt=L.instanceColor));let lt={};lt.attribute=tt,tt&&tt.data&&(lt.data=tt.data),z[q]=lt,V++}r.attributes=z,r.attributesNum=V,r.index=I}function x(){let L=r.newAttributes;for(let B=0,F=L.length;B<F;B++)L[B]=0}function m(L){p(L,0)}function p(L,B){let F=r.newAttributes,I=r.enabledAttributes,z=r.attributeDivisors;F[L]=1,I[L]===0&&(i.enableVertexAttribArray(L),I[L]=1),z[L]!==B&&(i.vertexAttribDivisor(L,B),z[L]=B)}function v(){let L=r.newAttributes,B=r.enabledAttributes;for(let F=0,I=B.length;F<I;F++)B[F]!==L[F]&&(i.disableVertexAttribArray(F),B[F]=0)}function A(L,B,F,I,z,X,V){V===!0?i.vertexAttribIPointer(L,B,F,z,X):i.vertexAttribPointer(L,B,F,I,z,X)}function M(L,B,F,I){x();let z=I.attributes,X=F.getAttributes(),V=B.defaultAttributeValues;for(let ot in X){let q=X[ot];if(q.location>=0){let j=z[ot];if(j===void 0&&(ot==="instanceMatrix"&&L.instanceMatrix&&(j=L.instanceMatrix),ot==="instanceColor"&&L.instanceColor&&(j=L.instanceColor)),j!==void 0){let tt=j.normalized,lt=j.itemSize,it=t.get(j);if(it===void 0)continue;let Z=it.buffer,ft=it.type,dt=it.bytesPerElement,Mt=ft===i.INT||ft===i.UNSIGNED_INT||j.gpuType===Mc;if(j.isInterleavedBufferAttribute){let gt=j.data,kt=gt.isInterleavedBuffer===!0?gt.stride:gt.itemSize,Wt=j.offset;if(gt.isInstancedInterleavedBuffer||gt.isInstancedBufferAttribute){for(let Nt=0;Nt<q.locationSize;Nt++)p(q.location+Nt,gt.meshPerAttribute);L.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=gt.meshPerAttribute*gt.count)}else for(let Nt=0;Nt<q.locationSize;Nt++)m(q.location+Nt);i.bindBuffer(i.ARRAY_BUFFER,Z);for(let Nt=0;Nt<q.locationSize;Nt++)A(q.location+Nt,lt/q.locationSize,ft,tt,kt*dt,(Wt+lt/q.locationSize*Nt)*dt,Mt)}else{if(j.isInstancedBufferAttribute){for(let gt=0;gt<q.locationSize;gt++)p(q.location+gt,j.meshPerAttribute);L.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let gt=0;gt<q.locationSize;gt++)m(q.location+gt);i.bindBuffer(i.ARRAY_BUFFER,Z);for(let gt=0;gt<q.locationSize;gt++)A(q.location+gt,lt/q.locationSize,ft,tt,lt*dt,lt/q.locationSize*gt*dt,Mt)}}else if(V!==void 0){let tt=V[ot];if(tt!==void 0)switch(tt.length){case 2:i.vertexAttrib2fv(q.location,tt);break;case 3:i.vertexAttrib3fv(q.location,tt);break;case 4:i.vertexAttrib4fv(q.location,tt);break;default:i.vertexAttrib1fv(q.location,tt)}}}}v()}function C(){U();for(let L in n){let B=n[L];for(let F in B){let I=B[F];for(let z in I){let X=I[z];for(let V in X)h(X[V].object),delete X[V];delete I[z]}}delete n[L]}}function S(L){if(n[L.id]===void 0)return;let B=n[L.id];for(let F in B){let I=B[F];for(let z in I){let X=I[z];for(let V in X)h(X[V].object),delete X[V];delete I[z]}}delete n[L.id]}function _(L){for(let B in n){let F=n[B];for(let I in F){let z=F[I];if(z[L.id]===void 0)continue;let X=z[L.id];for(let V in X)h(X[V].object),delete X[V];delete z[L.id]}}}function E(L){for(let B in n){let F=n[B],I=L.isInstancedMesh===!0?L.id:0,z=F[I];if(z!==void 0){for(let X in z){let V=z[X];for(let ot in V)h(V[ot].object),delete V[ot];delete z[X]}delete F[I],Object.keys(F).length===0&&delete n[B]}}}function U(){D(),o=!0,r!==s&&(r=s,c(r.object))}function D(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:D,dispose:C,releaseStatesOfGeometry:S,releaseStatesOfObject:E,releaseStatesOfProgram:_,initAttributes:x,enableAttribute:m,disableUnusedAttributes:v}}function Cb(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let f=0;for(let d=0;d<h;d++)f+=c[d];e.update(f,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Rb(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Fi&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let E=_===Ui&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==gi&&_!==Ni&&!E&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(Yt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),f=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&Yt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&Yt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),M=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),S=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:u,maxTextures:d,maxVertexTextures:g,maxTextureSize:x,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:v,maxVaryings:A,maxFragmentUniforms:M,maxSamples:C,samples:S}}function Pb(i){let t=this,e=null,n=0,s=!1,r=!1,o=new di,a=new ne,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let d=u.length!==0||f||n!==0||s;return s=f,n=u.length,d},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){e=h(u,f,0)},this.setState=function(u,f,d){let g=u.clippingPlanes,x=u.clipIntersection,m=u.clipShadows,p=i.get(u);if(!s||g===null||g.length===0||r&&!m)r?h(null):c();else{let v=r?0:n,A=v*4,M=p.clippingState||null;l.value=M,M=h(g,f,A,d);for(let C=0;C!==A;++C)M[C]=e[C];p.clippingState=M,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,f,d,g){let x=u!==null?u.length:0,m=null;if(x!==0){if(m=l.value,g!==!0||m===null){let p=d+x*4,v=f.matrixWorldInverse;a.getNormalMatrix(v),(m===null||m.length<p)&&(m=new Float32Array(p));for(let A=0,M=d;A!==x;++A,M+=4)o.copy(u[A]).applyMatrix4(v,a),o.normal.toArray(m,M),m[M+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,m}}var Ra=class extends pi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new ca(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Gs(5,5,5),r=new Pn({name:"CubemapFromEquirect",uniforms:xr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Zn,blending:pr});r.uniforms.tEquirect.value=e;let o=new tn(s,r),a=e.minFilter;return e.minFilter===Ms&&(e.minFilter=qn),new fo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},Lg=256,Ib=3,Lb=20,e0=256,n0=16,Db=3,Nb=new W,Ub=new pe,sh=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new fo(1,10,null),this._boxMesh=new tn(new Gs(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=Nb}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,g=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(Ub));let m=new fo(n,s,h);return m.position.copy(a),m.update(l,t),l.autoClear=u,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=g,t.background=x,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Ug(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Ng(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Lg,Cf(t))}_fromTexture(t,e){t.mapping===gr||t.mapping===_o?this._setSize(t.image.length===0?Lg:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=Dg(t,!1,!1),n=Math.log2(t)-Ib;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Dg(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===gr||t.mapping===_o?(this._cubemapMaterial===null&&(this._cubemapMaterial=Ug()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Ng()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Fb(),this._integrationMaterial=Ob());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/n0);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-Db)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(e0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Bb());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function Dg(i,t,e){return new Ra(i,{minFilter:Ms,generateMipmaps:t,type:Ui,colorSpace:Qo,depthBuffer:e})}function Pa(i,t,e){return new Pn({name:i,uniforms:t,vertexShader:ce.cube_vert,fragmentShader:e,side:Zn,blending:pr,depthTest:!1,depthWrite:!1})}function Fb(){return Pa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${e0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Ob(){return Pa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:n0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Bb(){return Pa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Lb}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Ng(){return Pa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Ug(){return Pa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function kb(i){let t=new WeakMap,e=new WeakMap,n=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===xc||d===yc)if(t.has(f)){let g=t.get(f).texture;return a(g,f.mapping)}else{let g=f.image;if(g&&g.height>0){let x=new Ra(g.height);return x.fromEquirectangularTexture(i,f),t.set(f,x),f.addEventListener("dispose",c),a(x.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,g=d===xc||d===yc,x=d===gr||d===_o;if(g||x){let m=e.get(f),p=m!==void 0?m.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==p)return n===null&&(n=new sh(i)),m=g?n.fromEquirectangular(f,m):n.fromCubemap(f,m),m.texture.pmremVersion=f.pmremVersion,e.set(f,m),m.texture;if(m!==void 0)return m.texture;{let v=f.image;return g&&v&&v.height>0||x&&v&&l(v)?(n===null&&(n=new sh(i)),m=g?n.fromEquirectangular(f):n.fromCubemap(f),m.texture.pmremVersion=f.pmremVersion,e.set(f,m),f.addEventListener("dispose",h),m.texture):null}}}return f}function a(f,d){return d===xc?f.mapping=gr:d===yc&&(f.mapping=_o),f}function l(f){let d=0,g=6;for(let x=0;x<g;x++)f[x]!==void 0&&d++;return d===g}function c(f){let d=f.target;d.removeEventListener("dispose",c);let g=t.get(d);g!==void 0&&(t.delete(d),g.dispose())}function h(f){let d=f.target;d.removeEventListener("dispose",h);let g=e.get(d);g!==void 0&&(e.delete(d),g.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function zb(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&Jo("WebGLRenderer: "+n+" extension not supported."),s}}}function Vb(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&t.remove(g.index);for(let m in g.attributes)t.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let x=r.get(g);x&&(t.remove(x),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function c(g,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function h(g){let x=g.attributes;for(let m in x)t.update(x[m],i.ARRAY_BUFFER)}function u(g){let x=g.index,m=g.attributes.position,p=0;if(m===void 0)return;let v=x!==null?x.array.length:m.array.length/3-1,A=m.count>=65535?aa:oa,M=new A(Math.ceil(v/3)*6,1),C=M.array;if(x!==null){let _=x.array;p=x.version;for(let E=0,U=0;E<v;E+=3){let D=_[E+0],L=_[E+1],B=_[E+2];C[U++]=D,C[U++]=L,C[U++]=L,C[U++]=B,C[U++]=B,C[U++]=D}}else{p=m.version;for(let _=0,E=0;_<v;_+=3){let U=_+0,D=_+1,L=_+2;C[E++]=U,C[E++]=D,C[E++]=D,C[E++]=L,C[E++]=L,C[E++]=U}}M.version=p;let S=r.get(g);S&&t.remove(S),r.set(g,M)}function f(g){let x=r.get(g);if(x){let m=g.index;m!==null&&x.version<m.version&&u(g)}else u(g);return r.get(g)}function d(){for(let g in s){let x=s[g].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:f,dispose:d}}function Gb(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,f){i.drawElements(n,f,r,u*o),e.update(f,n,1)}function c(u,f,d){d!==0&&(i.drawElementsInstanced(n,f,r,u*o,d),e.update(f,n,d))}function h(u,f,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,u,0,d);let x=0;for(let m=0;m<d;m++)x+=f[m];e.update(x,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function Hb(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:te("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function Wb(i,t,e){let n=new WeakMap,s=new De;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,f=n.get(a);if(f===void 0||f.count!==u){let U=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",U)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],A=0;d===!0&&(A=1),g===!0&&(A=2),x===!0&&(A=3);let M=a.attributes.position.count*A,C=1;M>t.maxTextureSize&&(C=Math.ceil(M/t.maxTextureSize),M=t.maxTextureSize);let S=new Float32Array(M*C*4*u),_=new ia(S,M,C,u);_.type=Ni,_.needsUpdate=!0;let E=A*4;for(let D=0;D<u;D++){let L=m[D],B=p[D],F=v[D],I=M*C*4*D;for(let z=0;z<L.count;z++){let X=z*E;d===!0&&(s.fromBufferAttribute(L,z),S[I+X+0]=s.x,S[I+X+1]=s.y,S[I+X+2]=s.z,S[I+X+3]=0),g===!0&&(s.fromBufferAttribute(B,z),S[I+X+4]=s.x,S[I+X+5]=s.y,S[I+X+6]=s.z,S[I+X+7]=0),x===!0&&(s.fromBufferAttribute(F,z),S[I+X+8]=s.x,S[I+X+9]=s.y,S[I+X+10]=s.z,S[I+X+11]=F.itemSize===4?s.w:1)}}f={count:u,texture:_,size:new re(M,C)},n.set(a,f),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let d=0;for(let x=0;x<c.length;x++)d+=c[x];let g=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function Xb(i,t,e,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,f=t.get(c,u);if(r.get(f)!==h&&(t.update(f),r.set(f,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==h&&(d.update(),r.set(d,h))}return f}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var qb={[of]:"LINEAR_TONE_MAPPING",[af]:"REINHARD_TONE_MAPPING",[lf]:"CINEON_TONE_MAPPING",[cf]:"ACES_FILMIC_TONE_MAPPING",[uf]:"AGX_TONE_MAPPING",[ff]:"NEUTRAL_TONE_MAPPING",[hf]:"CUSTOM_TONE_MAPPING"};function Yb(i,t,e,n,s,r){let o=new pi(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Oe;h.setAttribute("position",new Ge([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Ge([0,2,0,0,2,0],2));let u=new nc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new tn(h,u),d=new gc(-1,1,1,-1,0,1),g=null,x=null,m=!1,p,v=null,A=[],M=!1;this.setSize=function(C,S){o.setSize(C,S),a!==null&&a.setSize(C,S),l!==null&&l.setSize(C,S);for(let _=0;_<A.length;_++){let E=A[_];E.setSize&&E.setSize(C,S)}},this.setEffects=function(C){A=C,M=A.length>0&&A[0].isRenderPass===!0;let S=o.width,_=o.height;A.length>0&&a===null&&(a=new pi(S,_,{type:Ui,depthBuffer:!1,stencilBuffer:!1}),l=new pi(S,_,{type:Ui,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&A.some(U=>U.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new vs(S,_),r===!0&&(c.format=bs,c.type=_r)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let U=0;U<A.length;U++){let D=A[U];D.setSize&&D.setSize(S,_),E&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(c)}},this.begin=function(C,S){if(m||C.toneMapping===Ki&&A.length===0)return!1;if(v=S,S!==null){let _=S.width,E=S.height;(o.width!==_||o.height!==E)&&this.setSize(_,E)}return M===!1&&C.setRenderTarget(o),p=C.toneMapping,C.toneMapping=Ki,!0},this.hasRenderPass=function(){return M},this.end=function(C,S){C.toneMapping=p,m=!0;let _=o,E=a;for(let U=0;U<A.length;U++){let D=A[U];D.enabled!==!1&&(D.render(C,E,_,S),D.needsSwap!==!1&&(_=E,E=E===a?l:a))}if(g!==C.outputColorSpace||x!==C.toneMapping){g=C.outputColorSpace,x=C.toneMapping,u.defines={},ye.getTransfer(g)===Re&&(u.defines.SRGB_TRANSFER="");let U=qb[x];U&&(u.defines[U]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=_.texture,C.setRenderTarget(v),C.render(f,d),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var i0=new jn,s0=new vs(1,1),r0=new ha(1),o0=new ia,a0=new Jl,l0=new ca,Fg=[],Og=[],Bg=new Float32Array(16),kg=new Float32Array(9),zg=new Float32Array(4);function bo(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=Fg[s];if(r===void 0&&(r=new Float32Array(s),Fg[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function Mn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function bn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function oh(i,t){let e=Og[t];e===void 0&&(e=new Int32Array(t),Og[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function $b(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function Zb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;i.uniform2fv(this.addr,t),bn(e,t)}}function Jb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Mn(e,t))return;i.uniform3fv(this.addr,t),bn(e,t)}}function Kb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;i.uniform4fv(this.addr,t),bn(e,t)}}function jb(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Mn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),bn(e,t)}else{if(Mn(e,n))return;zg.set(n),i.uniformMatrix2fv(this.addr,!1,zg),bn(e,n)}}function Qb(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Mn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),bn(e,t)}else{if(Mn(e,n))return;kg.set(n),i.uniformMatrix3fv(this.addr,!1,kg),bn(e,n)}}function tS(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Mn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),bn(e,t)}else{if(Mn(e,n))return;Bg.set(n),i.uniformMatrix4fv(this.addr,!1,Bg),bn(e,n)}}function eS(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function nS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;i.uniform2iv(this.addr,t),bn(e,t)}}function iS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Mn(e,t))return;i.uniform3iv(this.addr,t),bn(e,t)}}function sS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;i.uniform4iv(this.addr,t),bn(e,t)}}function rS(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function oS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;i.uniform2uiv(this.addr,t),bn(e,t)}}function aS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Mn(e,t))return;i.uniform3uiv(this.addr,t),bn(e,t)}}function lS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;i.uniform4uiv(this.addr,t),bn(e,t)}}function ah(i){return i.version===0&&(i.compareFunction=wf,i.needsUpdate=!0),i}function cS(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=ah(s0):r=i0,e.setTexture2D(t||r,s)}function hS(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||a0,s)}function uS(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=ah(r0):r=l0,e.setTextureCube(t||r,s)}function fS(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||o0,s)}function dS(i){switch(i){case 5126:return $b;case 35664:return Zb;case 35665:return Jb;case 35666:return Kb;case 35674:return jb;case 35675:return Qb;case 35676:return tS;case 5124:case 35670:return eS;case 35667:case 35671:return nS;case 35668:case 35672:return iS;case 35669:case 35673:return sS;case 5125:return rS;case 36294:return oS;case 36295:return aS;case 36296:return lS;case 35678:case 36198:case 36298:case 36306:case 35682:return cS;case 35679:case 36299:case 36307:return hS;case 35680:case 36300:case 36308:case 36293:return uS;case 36289:case 36303:case 36311:case 36292:return fS}}function pS(i,t){i.uniform1fv(this.addr,t)}function mS(i,t){let e=bo(t,this.size,2);i.uniform2fv(this.addr,e)}function gS(i,t){let e=bo(t,this.size,3);i.uniform3fv(this.addr,e)}function _S(i,t){let e=bo(t,this.size,4);i.uniform4fv(this.addr,e)}function xS(i,t){let e=bo(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function yS(i,t){let e=bo(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function vS(i,t){let e=bo(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function MS(i,t){i.uniform1iv(this.addr,t)}function bS(i,t){i.uniform2iv(this.addr,t)}function SS(i,t){i.uniform3iv(this.addr,t)}function wS(i,t){i.uniform4iv(this.addr,t)}function ES(i,t){i.uniform1uiv(this.addr,t)}function TS(i,t){i.uniform2uiv(this.addr,t)}function AS(i,t){i.uniform3uiv(this.addr,t)}function CS(i,t){i.uniform4uiv(this.addr,t)}function RS(i,t,e){let n=this.cache,s=t.length,r=oh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=ah(s0):o=i0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function PS(i,t,e){let n=this.cache,s=t.length,r=oh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||a0,r[o])}function IS(i,t,e){let n=this.cache,s=t.length,r=oh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=ah(r0):o=l0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function LS(i,t,e){let n=this.cache,s=t.length,r=oh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||o0,r[o])}function DS(i){switch(i){case 5126:return pS;case 35664:return mS;case 35665:return gS;case 35666:return _S;case 35674:return xS;case 35675:return yS;case 35676:return vS;case 5124:case 35670:return MS;case 35667:case 35671:return bS;case 35668:case 35672:return SS;case 35669:case 35673:return wS;case 5125:return ES;case 36294:return TS;case 36295:return AS;case 36296:return CS;case 35678:case 36198:case 36298:case 36306:case 35682:return RS;case 35679:case 36299:case 36307:return PS;case 35680:case 36300:case 36308:case 36293:return IS;case 36289:case 36303:case 36311:case 36292:return LS}}var Of=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=dS(e.type)}},Bf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=DS(e.type)}},kf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},Uf=/(\w+)(\])?(\[|\.)?/g;function Vg(i,t){i.seq.push(t),i.map[t.id]=t}function NS(i,t,e){let n=i.name,s=n.length;for(Uf.lastIndex=0;;){let r=Uf.exec(n),o=Uf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Vg(e,c===void 0?new Of(a,i,t):new Bf(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new kf(a),Vg(e,u)),e=u}}}var Mo=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);NS(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function Gg(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var US=37297,FS=0;function OS(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var Hg=new ne;function BS(i){ye._getMatrix(Hg,ye.workingColorSpace,i);let t=`mat3( ${Hg.elements.map(e=>e.toFixed(4))} )`;switch(ye.getTransfer(i)){case ta:return[t,"LinearTransferOETF"];case Re:return[t,"sRGBTransferOETF"];default:return Yt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Wg(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+OS(i.getShaderSource(t),a)}else return r}function kS(i,t){let e=BS(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var zS={[of]:"Linear",[af]:"Reinhard",[lf]:"Cineon",[cf]:"ACESFilmic",[uf]:"AgX",[ff]:"Neutral",[hf]:"Custom"};function VS(i,t){let e=zS[t];return e===void 0?(Yt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var ih=new W;function GS(){ye.getLuminanceCoefficients(ih);let i=ih.x.toFixed(4),t=ih.y.toFixed(4),e=ih.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function HS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ca).join(`
`)}function WS(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function XS(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Ca(i){return i!==""}function Xg(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function qg(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var qS=/^[ \t]*#include +<([\w\d./]+)>/gm;function zf(i){return i.replace(qS,YS)}function YS(i,t){let e=ce[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return zf(e)}var $S=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Yg(i){return i.replace($S,ZS)}function ZS(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function $g(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var JS={[ya]:"SHADOWMAP_TYPE_PCF",[mo]:"SHADOWMAP_TYPE_VSM"};function KS(i){return JS[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var jS={[_o]:"ENVMAP_MODE_REFRACTION"};function QS(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":jS[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var tw={[rf]:"ENVMAP_BLENDING_MULTIPLY",[hg]:"ENVMAP_BLENDING_MIX",[ug]:"ENVMAP_BLENDING_ADD"};function ew(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":tw[i.combine]||"ENVMAP_BLENDING_NONE"}function nw(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=KS(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=QS(e),u=ew(e),f=HS(e),d=WS(r),g=s.createProgram(),x,m,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Ca).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Ca).join(`
`),m.length>0&&(m+=`
`)):(x=[$g(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ca).join(`
`),m=[$g(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Ki?"#define TONE_MAPPING":"",e.toneMapping!==Ki?ce.tonemapping_pars_fragment:"",e.toneMapping!==Ki?VS("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ce.colorspace_pars_fragment,kS("linearToOutputTexel",e.outputColorSpace),GS(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ca).join(`
`)),o=zf(o),o=Xg(o,e),o=qg(o,e),a=zf(a),a=Xg(a,e),a=qg(a,e),o=Yg(o),a=Yg(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,x=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",e.glslVersion===Ef?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Ef?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=p+x+o,A=p+m+a,M=Gg(s,s.VERTEX_SHADER,v),C=Gg(s,s.FRAGMENT_SHADER,A);s.attachShader(g,M),s.attachShader(g,C),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function S(D){if(i.debug.checkShaderErrors){let L=s.getProgramInfoLog(g)||"",B=s.getShaderInfoLog(M)||"",F=s.getShaderInfoLog(C)||"",I=L.trim(),z=B.trim(),X=F.trim(),V=!0,ot=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(V=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,M,C);else{let q=Wg(s,M,"vertex"),j=Wg(s,C,"fragment");te("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+D.name+`
Material Type: `+D.type+`

Program Info Log: `+I+`
`+q+`
`+j)}else I!==""?Yt("WebGLProgram: Program Info Log:",I):(z===""||X==="")&&(ot=!1);ot&&(D.diagnostics={runnable:V,programLog:I,vertexShader:{log:z,prefix:x},fragmentShader:{log:X,prefix:m}})}s.deleteShader(M),s.deleteShader(C),_=new Mo(s,g),E=XS(s,g)}let _;this.getUniforms=function(){return _===void 0&&S(this),_};let E;this.getAttributes=function(){return E===void 0&&S(this),E};let U=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(g,US)),U},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=FS++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=M,this.fragmentShader=C,this}var iw=0,Vf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Gf(t),e.set(t,n)),n}},Gf=class{constructor(t){this.id=iw++,this.code=t,this.usedTimes=0}};function sw(i){return i===Zs||i===Ea||i===Ta}function rw(i,t,e,n,s,r){let o=new sa,a=new Vf,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(_){return l.add(_),_===0?"uv":`uv${_}`}function g(_,E,U,D,L,B){let F=D.fog,I=L.geometry,z=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?D.environment:null,X=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,V=t.get(_.envMap||z,X),ot=f[_.type],q=n.precision;_.precision!==null&&(q=n.getMaxPrecision(_.precision),q!==_.precision&&Yt("WebGLProgram.getParameters:",_.precision,"not supported, using",q,"instead."));let j=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,tt=j!==void 0?j.length:0,lt=0;I.morphAttributes.position!==void 0&&(lt=1),I.morphAttributes.normal!==void 0&&(lt=2),I.morphAttributes.color!==void 0&&(lt=3);let it,Z,ft,dt;if(ot){let At=Qi[ot];it=At.vertexShader,Z=At.fragmentShader}else{it=_.vertexShader,Z=_.fragmentShader;let At=a.getVertexShaderStage(_),oe=a.getFragmentShaderStage(_);a.update(_,At,oe),ft=At.id,dt=oe.id}let Mt=i.getRenderTarget(),gt=i.state.buffers.depth.getReversed(),kt=L.isInstancedMesh===!0,Wt=L.isBatchedMesh===!0,Nt=!!_.map,ee=!!_.matcap,jt=!!V,Xt=jt&&V.isPMREMTexture===!0,Ne=!!_.aoMap,ae=!!_.lightMap,Ue=!!_.bumpMap&&_.wireframe===!1,ge=!!_.normalMap,Ke=!!_.displacementMap,be=!!_.emissiveMap,_n=!!_.metalnessMap,en=!!_.roughnessMap,cn=_.anisotropy>0,k=_.clearcoat>0,Ct=_.diffuseRoughness>0,$t=_.dispersion>0,se=_.retroreflectivity>0,St=_.iridescence>0,Be=_.sheen>0,Vt=_.transmission>0,qt=cn&&!!_.anisotropyMap,R=k&&!!_.clearcoatMap,b=k&&!!_.clearcoatNormalMap,Y=k&&!!_.clearcoatRoughnessMap,ut=Ct&&!!_.diffuseRoughnessMap,at=St&&!!_.iridescenceMap,xt=St&&!!_.iridescenceThicknessMap,yt=Be&&!!_.sheenColorMap,et=Be&&!!_.sheenRoughnessMap,st=!!_.specularMap,mt=!!_.specularColorMap,O=!!_.specularIntensityMap,rt=Vt&&!!_.transmissionMap,nt=Vt&&!!_.thicknessMap,wt=!!_.gradientMap,_t=!!_.alphaMap,bt=_.alphaTest>0,Gt=!!_.alphaHash,Jt=!!_.extensions,ht=Ki;_.toneMapped&&(Mt===null||Mt.isXRRenderTarget===!0)&&(ht=i.toneMapping);let Ot=Xt?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,Kt={shaderID:ot,shaderType:_.type,shaderName:_.name,vertexShader:it,fragmentShader:Z,defines:_.defines,customVertexShaderID:ft,customFragmentShaderID:dt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:q,batching:Wt,batchingColor:Wt&&L._colorsTexture!==null,instancing:kt,instancingColor:kt&&L.instanceColor!==null,instancingMorph:kt&&L.morphTexture!==null,outputColorSpace:Mt===null?i.outputColorSpace:Mt.isXRRenderTarget===!0?Mt.texture.colorSpace:ye.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Nt,matcap:ee,envMap:jt,envMapMode:jt&&V.mapping,envMapPMREM:Xt,envMapMaxLod:Xt?Ot.length-1:null,envMapSize:Xt?Ot[0].width:null,aoMap:Ne,lightMap:ae,bumpMap:Ue,normalMap:ge,displacementMap:Ke,emissiveMap:be,normalMapObjectSpace:ge&&_.normalMapType===pg,normalMapTangentSpace:ge&&_.normalMapType===Mf,packedNormalMap:ge&&_.normalMapType===Mf&&sw(_.normalMap.format),metalnessMap:_n,roughnessMap:en,anisotropy:cn,anisotropyMap:qt,clearcoat:k,clearcoatMap:R,clearcoatNormalMap:b,clearcoatRoughnessMap:Y,diffuseRoughness:Ct,diffuseRoughnessMap:ut,dispersion:$t,retroreflection:se,iridescence:St,iridescenceMap:at,iridescenceThicknessMap:xt,sheen:Be,sheenColorMap:yt,sheenRoughnessMap:et,specularMap:st,specularColorMap:mt,specularIntensityMap:O,transmission:Vt,transmissionMap:rt,thicknessMap:nt,gradientMap:wt,opaque:_.transparent===!1&&_.blending===go&&_.alphaToCoverage===!1,alphaMap:_t,alphaTest:bt,alphaHash:Gt,combine:_.combine,mapUv:Nt&&d(_.map.channel),aoMapUv:Ne&&d(_.aoMap.channel),lightMapUv:ae&&d(_.lightMap.channel),bumpMapUv:Ue&&d(_.bumpMap.channel),normalMapUv:ge&&d(_.normalMap.channel),displacementMapUv:Ke&&d(_.displacementMap.channel),emissiveMapUv:be&&d(_.emissiveMap.channel),metalnessMapUv:_n&&d(_.metalnessMap.channel),roughnessMapUv:en&&d(_.roughnessMap.channel),anisotropyMapUv:qt&&d(_.anisotropyMap.channel),clearcoatMapUv:R&&d(_.clearcoatMap.channel),clearcoatNormalMapUv:b&&d(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Y&&d(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ut&&d(_.diffuseRoughnessMap.channel),iridescenceMapUv:at&&d(_.iridescenceMap.channel),iridescenceThicknessMapUv:xt&&d(_.iridescenceThicknessMap.channel),sheenColorMapUv:yt&&d(_.sheenColorMap.channel),sheenRoughnessMapUv:et&&d(_.sheenRoughnessMap.channel),specularMapUv:st&&d(_.specularMap.channel),specularColorMapUv:mt&&d(_.specularColorMap.channel),specularIntensityMapUv:O&&d(_.specularIntensityMap.channel),transmissionMapUv:rt&&d(_.transmissionMap.channel),thicknessMapUv:nt&&d(_.thicknessMap.channel),alphaMapUv:_t&&d(_.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(ge||cn),vertexNormals:!!I.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!I.attributes.uv&&(Nt||_t),fog:!!F,useFog:_.fog===!0,fogExp2:!!F&&F.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||I.attributes.normal===void 0&&ge===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:gt,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:tt,morphTextureStride:lt,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:B.filter(At=>At.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&U.length>0,shadowMapType:i.shadowMap.type,toneMapping:ht,decodeVideoTexture:Nt&&_.map.isVideoTexture===!0&&ye.getTransfer(_.map.colorSpace)===Re,decodeVideoTextureEmissive:be&&_.emissiveMap.isVideoTexture===!0&&ye.getTransfer(_.emissiveMap.colorSpace)===Re,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Dn,flipSided:_.side===Zn,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:Jt&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Jt&&_.extensions.multiDraw===!0||Wt)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Kt.vertexUv1s=l.has(1),Kt.vertexUv2s=l.has(2),Kt.vertexUv3s=l.has(3),l.clear(),Kt}function x(_){let E=[];if(_.shaderID?E.push(_.shaderID):(E.push(_.customVertexShaderID),E.push(_.customFragmentShaderID)),_.defines!==void 0)for(let U in _.defines)E.push(U),E.push(_.defines[U]);return _.isRawShaderMaterial===!1&&(m(E,_),p(E,_),E.push(i.outputColorSpace)),E.push(_.customProgramCacheKey),E.join()}function m(_,E){_.push(E.precision),_.push(E.outputColorSpace),_.push(E.envMapMode),_.push(E.envMapPMREM),_.push(E.envMapMaxLod),_.push(E.envMapSize),_.push(E.mapUv),_.push(E.alphaMapUv),_.push(E.lightMapUv),_.push(E.aoMapUv),_.push(E.bumpMapUv),_.push(E.normalMapUv),_.push(E.displacementMapUv),_.push(E.emissiveMapUv),_.push(E.metalnessMapUv),_.push(E.roughnessMapUv),_.push(E.anisotropyMapUv),_.push(E.clearcoatMapUv),_.push(E.clearcoatNormalMapUv),_.push(E.clearcoatRoughnessMapUv),_.push(E.diffuseRoughnessMapUv),_.push(E.iridescenceMapUv),_.push(E.iridescenceThicknessMapUv),_.push(E.sheenColorMapUv),_.push(E.sheenRoughnessMapUv),_.push(E.specularMapUv),_.push(E.specularColorMapUv),_.push(E.specularIntensityMapUv),_.push(E.transmissionMapUv),_.push(E.thicknessMapUv),_.push(E.combine),_.push(E.fogExp2),_.push(E.sizeAttenuation),_.push(E.morphTargetsCount),_.push(E.numSunLights),_.push(E.numDirLights),_.push(E.numPointLights),_.push(E.numSpotLights),_.push(E.numSpotLightMaps),_.push(E.numHemiLights),_.push(E.numRectAreaLights),_.push(E.numSunLightShadows),_.push(E.numDirLightShadows),_.push(E.numPointLightShadows),_.push(E.numSpotLightShadows),_.push(E.numSpotLightShadowsWithMaps),_.push(E.numLightProbes),_.push(E.numLightProbeGrids),_.push(E.shadowMapType),_.push(E.toneMapping),_.push(E.numClippingPlanes),_.push(E.numClipIntersection),_.push(E.depthPacking)}function p(_,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let E=f[_.type],U;if(E){let D=Qi[E];U=Rg.clone(D.uniforms)}else U=_.uniforms;return U}function A(_,E){let U=h.get(E);return U!==void 0?++U.usedTimes:(U=new nw(i,E,_,s),c.push(U),h.set(E,U)),U}function M(_){if(--_.usedTimes===0){let E=c.indexOf(_);c[E]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function C(_){a.remove(_)}function S(){a.dispose()}return{getParameters:g,getProgramCacheKey:x,getUniforms:v,acquireProgram:A,releaseProgram:M,releaseShaderCache:C,programs:c,dispose:S}}function ow(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function aw(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function Zg(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Jg(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,g,x,m,p){let v=i[t];return v===void 0?(v={id:f.id,object:f,geometry:d,material:g,materialVariant:o(f),groupOrder:x,renderOrder:f.renderOrder,z:m,group:p},i[t]=v):(v.id=f.id,v.object=f,v.geometry=d,v.material=g,v.materialVariant=o(f),v.groupOrder=x,v.renderOrder=f.renderOrder,v.z=m,v.group=p),t++,v}function l(f,d,g,x,m,p,v){v.reversedDepth===!0&&(m=-m);let A=a(f,d,g,x,m,p);g.transmission>0?n.push(A):g.transparent===!0?s.push(A):e.push(A)}function c(f,d,g,x,m,p){let v=a(f,d,g,x,m,p);g.transmission>0?n.unshift(v):g.transparent===!0?s.unshift(v):e.unshift(v)}function h(f,d){e.length>1&&e.sort(f||aw),n.length>1&&n.sort(d||Zg),s.length>1&&s.sort(d||Zg)}function u(){for(let f=t,d=i.length;f<d;f++){let g=i[f];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function lw(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new Jg,i.set(n,[o])):s>=r.length?(o=new Jg,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function cw(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new W,color:new pe};break;case"SpotLight":e={position:new W,direction:new W,color:new pe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new W,color:new pe,distance:0,decay:0};break;case"HemisphereLight":e={direction:new W,skyColor:new pe,groundColor:new pe};break;case"RectAreaLight":e={color:new pe,position:new W,halfWidth:new W,halfHeight:new W};break}return i[t.id]=e,e}}}function hw(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new re};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new re};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new re,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var uw=0;function fw(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function dw(i){let t=new cw,e=hw(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new W);let s=new W,r=new Je,o=new Je;function a(c){let h=0,u=0,f=0;for(let B=0;B<9;B++)n.probe[B].set(0,0,0);let d=0,g=0,x=0,m=0,p=0,v=0,A=0,M=0,C=0,S=0,_=0,E=0,U=0,D=0;c.sort(fw);for(let B=0,F=c.length;B<F;B++){let I=c[B],z=I.color,X=I.intensity,V=I.distance,ot=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===Zs?ot=I.shadow.map.texture:ot=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=z.r*X,u+=z.g*X,f+=z.b*X;else if(I.isLightProbe){for(let q=0;q<9;q++)n.probe[q].addScaledVector(I.sh.coefficients[q],X);D++}else if(I.isSunLight){let q=t.get(I);if(q.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let j=I.shadow,tt=e.get(I);tt.shadowIntensity=j.intensity,tt.shadowBias=j.bias,tt.shadowNormalBias=j.normalBias,tt.shadowRadius=j.radius,tt.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),n.sunShadow[g]=tt,n.sunShadowMap[g]=ot;let lt=j.getViewportCount();for(let it=0;it<lt;it++)n.sunShadowMatrix[x+it]=j.getMatrix(it),n.sunShadowCascade[x+it]=j._cascadeData[it];x+=lt,g++}n.sun[d]=q,d++}else if(I.isDirectionalLight){let q=t.get(I);if(q.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let j=I.shadow,tt=e.get(I);tt.shadowIntensity=j.intensity,tt.shadowBias=j.bias,tt.shadowNormalBias=j.normalBias,tt.shadowRadius=j.radius,tt.shadowMapSize=j.mapSize,n.directionalShadow[m]=tt,n.directionalShadowMap[m]=ot,n.directionalShadowMatrix[m]=I.shadow.matrix,C++}n.directional[m]=q,m++}else if(I.isSpotLight){let q=t.get(I);q.position.setFromMatrixPosition(I.matrixWorld),q.color.copy(z).multiplyScalar(X),q.distance=V,q.coneCos=Math.cos(I.angle),q.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),q.decay=I.decay,n.spot[v]=q;let j=I.shadow;if(I.map&&(n.spotLightMap[E]=I.map,E++,j.updateMatrices(I),I.castShadow&&U++),n.spotLightMatrix[v]=j.matrix,I.castShadow){let tt=e.get(I);tt.shadowIntensity=j.intensity,tt.shadowBias=j.bias,tt.shadowNormalBias=j.normalBias,tt.shadowRadius=j.radius,tt.shadowMapSize=j.mapSize,n.spotShadow[v]=tt,n.spotShadowMap[v]=ot,_++}v++}else if(I.isRectAreaLight){let q=t.get(I);q.color.copy(z).multiplyScalar(X),q.halfWidth.set(I.width*.5,0,0),q.halfHeight.set(0,I.height*.5,0),n.rectArea[A]=q,A++}else if(I.isPointLight){let q=t.get(I);if(q.color.copy(I.color).multiplyScalar(I.intensity),q.distance=I.distance,q.decay=I.decay,I.castShadow){let j=I.shadow,tt=e.get(I);tt.shadowIntensity=j.intensity,tt.shadowBias=j.bias,tt.shadowNormalBias=j.normalBias,tt.shadowRadius=j.radius,tt.shadowMapSize=j.mapSize,tt.shadowCameraNear=j.camera.near,tt.shadowCameraFar=j.camera.far,n.pointShadow[p]=tt,n.pointShadowMap[p]=ot,n.pointShadowMatrix[p]=I.shadow.matrix,S++}n.point[p]=q,p++}else if(I.isHemisphereLight){let q=t.get(I);q.skyColor.copy(I.color).multiplyScalar(X),q.groundColor.copy(I.groundColor).multiplyScalar(X),n.hemi[M]=q,M++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=It.LTC_FLOAT_1,n.rectAreaLTC2=It.LTC_FLOAT_2):(n.rectAreaLTC1=It.LTC_HALF_1,n.rectAreaLTC2=It.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=f;let L=n.hash;(L.sunLength!==d||L.directionalLength!==m||L.pointLength!==p||L.spotLength!==v||L.rectAreaLength!==A||L.hemiLength!==M||L.numSunShadows!==g||L.numDirectionalShadows!==C||L.numPointShadows!==S||L.numSpotShadows!==_||L.numSpotMaps!==E||L.numLightProbes!==D)&&(n.sun.length=d,n.directional.length=m,n.spot.length=v,n.rectArea.length=A,n.point.length=p,n.hemi.length=M,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=S,n.pointShadowMap.length=S,n.pointShadowMatrix.length=S,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+E-U,n.spotLightMap.length=E,n.numSpotLightShadowsWithMaps=U,n.numLightProbes=D,L.sunLength=d,L.directionalLength=m,L.pointLength=p,L.spotLength=v,L.rectAreaLength=A,L.hemiLength=M,L.numSunShadows=g,L.numDirectionalShadows=C,L.numPointShadows=S,L.numSpotShadows=_,L.numSpotMaps=E,L.numLightProbes=D,n.version=uw++)}function l(c,h){let u=0,f=0,d=0,g=0,x=0,m=0,p=h.matrixWorldInverse;for(let v=0,A=c.length;v<A;v++){let M=c[v];if(M.isSunLight){let C=n.sun[u];C.direction.setFromMatrixPosition(M.matrixWorld),C.direction.transformDirection(p),u++}else if(M.isDirectionalLight){let C=n.directional[f];C.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),f++}else if(M.isSpotLight){let C=n.spot[g];C.position.setFromMatrixPosition(M.matrixWorld),C.position.applyMatrix4(p),C.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),g++}else if(M.isRectAreaLight){let C=n.rectArea[x];C.position.setFromMatrixPosition(M.matrixWorld),C.position.applyMatrix4(p),o.identity(),r.copy(M.matrixWorld),r.premultiply(p),o.extractRotation(r),C.halfWidth.set(M.width*.5,0,0),C.halfHeight.set(0,M.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),x++}else if(M.isPointLight){let C=n.point[d];C.position.setFromMatrixPosition(M.matrixWorld),C.position.applyMatrix4(p),d++}else if(M.isHemisphereLight){let C=n.hemi[m];C.direction.setFromMatrixPosition(M.matrixWorld),C.direction.transformDirection(p),m++}}}return{setup:a,setupView:l,state:n}}function Kg(i){let t=new dw(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){n.push(u)}function l(){t.setup(e),s.sort((u,f)=>u.priority-f.priority||u.id-f.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function pw(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Kg(i),t.set(s,[a])):r>=o.length?(a=new Kg(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var mw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,gw=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,_w=[new W(1,0,0),new W(-1,0,0),new W(0,1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1)],xw=[new W(0,-1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1),new W(0,-1,0),new W(0,-1,0)],jg=new Je,Aa=new W,Ff=new W;function yw(i,t,e){let n=new dr,s=new re,r=new re,o=new De,a=new ic,l=new sc,c={},h=e.maxTextureSize,u={[$s]:Zn,[Zn]:$s,[Dn]:Dn},f=new Pn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new re},radius:{value:4}},vertexShader:mw,fragmentShader:gw}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let g=new Oe;g.setAttribute("position",new Ve(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new tn(g,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ya;let p=this.type;this.render=function(S,_,E){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||S.length===0)return;this.type===Xm&&(Yt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ya);let U=i.getRenderTarget(),D=i.getActiveCubeFace(),L=i.getActiveMipmapLevel(),B=i.state;B.setBlending(pr),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let F=p!==this.type;F&&_.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(z=>z.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,z=S.length;I<z;I++){let X=S[I],V=X.shadow;if(V===void 0){Yt("WebGLShadowMap:",X,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let ot=V.getFrameExtents();s.multiply(ot),r.copy(V.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ot.x),s.x=r.x*ot.x,V.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ot.y),s.y=r.y*ot.y,V.mapSize.y=r.y));let q=i.state.buffers.depth.getReversed();if(V.camera._reversedDepth=q,V.map===null||F===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===mo){if(X.isPointLight){Yt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new pi(s.x,s.y,{format:Zs,type:Ui,minFilter:qn,magFilter:qn,generateMipmaps:!1}),V.map.texture.name=X.name+".shadowMap",V.map.depthTexture=new vs(s.x,s.y,Ni),V.map.depthTexture.name=X.name+".shadowMapDepth",V.map.depthTexture.format=_s,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Rn,V.map.depthTexture.magFilter=Rn}else X.isPointLight?(V.map=new Ra(s.x),V.map.depthTexture=new ha(s.x,_i)):(V.map=new pi(s.x,s.y),V.map.depthTexture=new vs(s.x,s.y,_i)),V.map.depthTexture.name=X.name+".shadowMap",V.map.depthTexture.format=_s,this.type===ya?(V.map.depthTexture.compareFunction=q?Sf:bf,V.map.depthTexture.minFilter=qn,V.map.depthTexture.magFilter=qn):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Rn,V.map.depthTexture.magFilter=Rn);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let j=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();X.isPointLight!==!0&&V.updateMatrices(X,E);let tt=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:E.layers;for(let lt=0;lt<j;lt++){let it=V.getCamera(lt);if(X.isPointLight){let Z=V.camera,ft=V.matrix,dt=X.distance||Z.far;dt!==Z.far&&(Z.far=dt,Z.updateProjectionMatrix()),Aa.setFromMatrixPosition(X.matrixWorld),Z.position.copy(Aa),Ff.copy(Z.position),Ff.add(_w[lt]),Z.up.copy(xw[lt]),Z.lookAt(Ff),Z.updateMatrixWorld(),ft.makeTranslation(-Aa.x,-Aa.y,-Aa.z),jg.multiplyMatrices(Z.projectionMatrix,Z.matrixWorldInverse),V._frustum.setFromProjectionMatrix(jg,Z.coordinateSystem,Z.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)i.setRenderTarget(V.map,lt),i.clear();else{lt===0&&(i.setRenderTarget(V.map),i.clear());let Z=V.getViewport(lt);o.set(r.x*Z.x,r.y*Z.y,r.x*Z.z,r.y*Z.w),B.viewport(o)}n=V.getFrustum(lt),M(_,E,it,X,tt,this.type)}V.isPointLightShadow!==!0&&this.type===mo&&v(V,E),V.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(U,D,L)};function v(S,_){let E=t.update(x);f.defines.VSM_SAMPLES!==S.blurSamples&&(f.defines.VSM_SAMPLES=S.blurSamples,d.defines.VSM_SAMPLES=S.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),S.mapPass===null?S.mapPass=new pi(s.x,s.y,{format:Zs,type:Ui}):(S.mapPass.width!==S.map.width||S.mapPass.height!==S.map.height)&&S.mapPass.setSize(S.map.width,S.map.height),f.uniforms.shadow_pass.value=S.map.depthTexture,f.uniforms.resolution.value.set(S.map.width,S.map.height),f.uniforms.radius.value=S.radius,i.setRenderTarget(S.mapPass),i.clear(),i.renderBufferDirect(_,null,E,f,x,null),d.uniforms.shadow_pass.value=S.mapPass.texture,d.uniforms.resolution.value.set(S.map.width,S.map.height),d.uniforms.radius.value=S.radius,i.setRenderTarget(S.map),i.clear(),i.renderBufferDirect(_,null,E,d,x,null)}function A(S,_,E,U){let D=null,L=E.isPointLight===!0?S.customDistanceMaterial:S.customDepthMaterial;if(L!==void 0)D=L;else if(D=E.isPointLight===!0?l:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let B=D.uuid,F=_.uuid,I=c[B];I===void 0&&(I={},c[B]=I);let z=I[F];z===void 0&&(z=D.clone(),I[F]=z,_.addEventListener("dispose",C)),D=z}if(D.visible=_.visible,D.wireframe=_.wireframe,U===mo?D.side=_.shadowSide!==null?_.shadowSide:_.side:D.side=_.shadowSide!==null?_.shadowSide:u[_.side],D.alphaMap=_.alphaMap,D.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,D.map=_.map,D.clipShadows=_.clipShadows,D.clippingPlanes=_.clippingPlanes,D.clipIntersection=_.clipIntersection,D.displacementMap=_.displacementMap,D.displacementScale=_.displacementScale,D.displacementBias=_.displacementBias,D.wireframeLinewidth=_.wireframeLinewidth,D.linewidth=_.linewidth,E.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let B=i.properties.get(D);B.light=E}return D}function M(S,_,E,U,D,L){if(S.visible===!1)return;if(S.layers.test(D)&&(S.isMesh||S.isLine||S.isPoints)&&(S.castShadow||S.receiveShadow&&L===mo)&&(!S.frustumCulled||S.intersectsFrustum(n))){S.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,S.matrixWorld);let I=t.update(S),z=S.material;if(Array.isArray(z)){let X=I.groups;for(let V=0,ot=X.length;V<ot;V++){let q=X[V],j=z[q.materialIndex];if(j&&j.visible){let tt=A(S,j,U,L);S.onBeforeShadow(i,S,_,E,I,tt,q),i.renderBufferDirect(E,null,I,tt,S,q),S.onAfterShadow(i,S,_,E,I,tt,q)}}}else if(z.visible){let X=A(S,z,U,L);S.onBeforeShadow(i,S,_,E,I,X,null),i.renderBufferDirect(E,null,I,X,S,null),S.onAfterShadow(i,S,_,E,I,X,null)}}let F=S.children;for(let I=0,z=F.length;I<z;I++)M(F[I],_,E,U,D,L)}function C(S){S.target.removeEventListener("dispose",C);for(let E in c){let U=c[E],D=S.target.uuid;D in U&&(U[D].dispose(),delete U[D])}}}function vw(i,t){function e(){let O=!1,rt=new De,nt=null,wt=new De(0,0,0,0);return{setMask:function(_t){nt!==_t&&!O&&(i.colorMask(_t,_t,_t,_t),nt=_t)},setLocked:function(_t){O=_t},setClear:function(_t,bt,Gt,Jt,ht){ht===!0&&(_t*=Jt,bt*=Jt,Gt*=Jt),rt.set(_t,bt,Gt,Jt),wt.equals(rt)===!1&&(i.clearColor(_t,bt,Gt,Jt),wt.copy(rt))},reset:function(){O=!1,nt=null,wt.set(-1,0,0,0)}}}function n(){let O=!1,rt=!1,nt=null,wt=null,_t=null;return{setReversed:function(bt){if(rt!==bt){let Gt=t.get("EXT_clip_control");bt?Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.ZERO_TO_ONE_EXT):Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.NEGATIVE_ONE_TO_ONE_EXT),rt=bt;let Jt=_t;_t=null,this.setClear(Jt)}},getReversed:function(){return rt},setTest:function(bt){bt?gt(i.DEPTH_TEST):kt(i.DEPTH_TEST)},setMask:function(bt){nt!==bt&&!O&&(i.depthMask(bt),nt=bt)},setFunc:function(bt){if(rt&&(bt=Eg[bt]),wt!==bt){switch(bt){case Bl:i.depthFunc(i.NEVER);break;case kl:i.depthFunc(i.ALWAYS);break;case zl:i.depthFunc(i.LESS);break;case ro:i.depthFunc(i.LEQUAL);break;case Vl:i.depthFunc(i.EQUAL);break;case Gl:i.depthFunc(i.GEQUAL);break;case Hl:i.depthFunc(i.GREATER);break;case Wl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}wt=bt}},setLocked:function(bt){O=bt},setClear:function(bt){_t!==bt&&(_t=bt,rt&&(bt=1-bt),i.clearDepth(bt))},reset:function(){O=!1,nt=null,wt=null,_t=null,rt=!1}}}function s(){let O=!1,rt=null,nt=null,wt=null,_t=null,bt=null,Gt=null,Jt=null,ht=null;return{setTest:function(Ot){O||(Ot?gt(i.STENCIL_TEST):kt(i.STENCIL_TEST))},setMask:function(Ot){rt!==Ot&&!O&&(i.stencilMask(Ot),rt=Ot)},setFunc:function(Ot,Kt,At){(nt!==Ot||wt!==Kt||_t!==At)&&(i.stencilFunc(Ot,Kt,At),nt=Ot,wt=Kt,_t=At)},setOp:function(Ot,Kt,At){(bt!==Ot||Gt!==Kt||Jt!==At)&&(i.stencilOp(Ot,Kt,At),bt=Ot,Gt=Kt,Jt=At)},setLocked:function(Ot){O=Ot},setClear:function(Ot){ht!==Ot&&(i.clearStencil(Ot),ht=Ot)},reset:function(){O=!1,rt=null,nt=null,wt=null,_t=null,bt=null,Gt=null,Jt=null,ht=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,h={},u={},f={},d=new WeakMap,g=[],x=null,m=!1,p=null,v=null,A=null,M=null,C=null,S=null,_=null,E=new pe(0,0,0),U=0,D=!1,L=null,B=null,F=null,I=null,z=null,X=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,ot=0,q=i.getParameter(i.VERSION);q.indexOf("WebGL")!==-1?(ot=parseFloat(/^WebGL (\d)/.exec(q)[1]),V=ot>=1):q.indexOf("OpenGL ES")!==-1&&(ot=parseFloat(/^OpenGL ES (\d)/.exec(q)[1]),V=ot>=2);let j=null,tt={},lt=i.getParameter(i.SCISSOR_BOX),it=i.getParameter(i.VIEWPORT),Z=new De().fromArray(lt),ft=new De().fromArray(it);function dt(O,rt,nt,wt){let _t=new Uint8Array(4),bt=i.createTexture();i.bindTexture(O,bt),i.texParameteri(O,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(O,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Gt=0;Gt<nt;Gt++)O===i.TEXTURE_3D||O===i.TEXTURE_2D_ARRAY?i.texImage3D(rt,0,i.RGBA,1,1,wt,0,i.RGBA,i.UNSIGNED_BYTE,_t):i.texImage2D(rt+Gt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,_t);return bt}let Mt={};Mt[i.TEXTURE_2D]=dt(i.TEXTURE_2D,i.TEXTURE_2D,1),Mt[i.TEXTURE_CUBE_MAP]=dt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Mt[i.TEXTURE_2D_ARRAY]=dt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Mt[i.TEXTURE_3D]=dt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),gt(i.DEPTH_TEST),o.setFunc(ro),Ue(!1),ge(ju),gt(i.CULL_FACE),Ne(pr);function gt(O){h[O]!==!0&&(i.enable(O),h[O]=!0)}function kt(O){h[O]!==!1&&(i.disable(O),h[O]=!1)}function Wt(O,rt){return f[O]!==rt?(i.bindFramebuffer(O,rt),f[O]=rt,O===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=rt),O===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=rt),!0):!1}function Nt(O,rt){let nt=g,wt=!1;if(O){nt=d.get(rt),nt===void 0&&(nt=[],d.set(rt,nt));let _t=O.textures;if(nt.length!==_t.length||nt[0]!==i.COLOR_ATTACHMENT0){for(let bt=0,Gt=_t.length;bt<Gt;bt++)nt[bt]=i.COLOR_ATTACHMENT0+bt;nt.length=_t.length,wt=!0}}else nt[0]!==i.BACK&&(nt[0]=i.BACK,wt=!0);wt&&i.drawBuffers(nt)}function ee(O){return x!==O?(i.useProgram(O),x=O,!0):!1}let jt={[mr]:i.FUNC_ADD,[Ym]:i.FUNC_SUBTRACT,[$m]:i.FUNC_REVERSE_SUBTRACT};jt[Zm]=i.MIN,jt[Jm]=i.MAX;let Xt={[Km]:i.ZERO,[jm]:i.ONE,[Qm]:i.SRC_COLOR,[nf]:i.SRC_ALPHA,[rg]:i.SRC_ALPHA_SATURATE,[ig]:i.DST_COLOR,[eg]:i.DST_ALPHA,[tg]:i.ONE_MINUS_SRC_COLOR,[sf]:i.ONE_MINUS_SRC_ALPHA,[sg]:i.ONE_MINUS_DST_COLOR,[ng]:i.ONE_MINUS_DST_ALPHA,[og]:i.CONSTANT_COLOR,[ag]:i.ONE_MINUS_CONSTANT_COLOR,[lg]:i.CONSTANT_ALPHA,[cg]:i.ONE_MINUS_CONSTANT_ALPHA};function Ne(O,rt,nt,wt,_t,bt,Gt,Jt,ht,Ot){if(O===pr){m===!0&&(kt(i.BLEND),m=!1);return}if(m===!1&&(gt(i.BLEND),m=!0),O!==qm){if(O!==p||Ot!==D){if((v!==mr||C!==mr)&&(i.blendEquation(i.FUNC_ADD),v=mr,C=mr),Ot)switch(O){case go:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Qu:i.blendFunc(i.ONE,i.ONE);break;case tf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case ef:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:te("WebGLState: Invalid blending: ",O);break}else switch(O){case go:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Qu:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case tf:te("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ef:te("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:te("WebGLState: Invalid blending: ",O);break}A=null,M=null,S=null,_=null,E.set(0,0,0),U=0,p=O,D=Ot}return}_t=_t||rt,bt=bt||nt,Gt=Gt||wt,(rt!==v||_t!==C)&&(i.blendEquationSeparate(jt[rt],jt[_t]),v=rt,C=_t),(nt!==A||wt!==M||bt!==S||Gt!==_)&&(i.blendFuncSeparate(Xt[nt],Xt[wt],Xt[bt],Xt[Gt]),A=nt,M=wt,S=bt,_=Gt),(Jt.equals(E)===!1||ht!==U)&&(i.blendColor(Jt.r,Jt.g,Jt.b,ht),E.copy(Jt),U=ht),p=O,D=!1}function ae(O,rt){O.side===Dn?kt(i.CULL_FACE):gt(i.CULL_FACE);let nt=O.side===Zn;rt&&(nt=!nt),Ue(nt),O.blending===go&&O.transparent===!1?Ne(pr):Ne(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let wt=O.stencilWrite;a.setTest(wt),wt&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),be(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?gt(i.SAMPLE_ALPHA_TO_COVERAGE):kt(i.SAMPLE_ALPHA_TO_COVERAGE)}function Ue(O){L!==O&&(O?i.frontFace(i.CW):i.frontFace(i.CCW),L=O)}function ge(O){O!==Hm?(gt(i.CULL_FACE),O!==B&&(O===ju?i.cullFace(i.BACK):O===Wm?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):kt(i.CULL_FACE),B=O}function Ke(O){O!==F&&(V&&i.lineWidth(O),F=O)}function be(O,rt,nt){O?(gt(i.POLYGON_OFFSET_FILL),(I!==rt||z!==nt)&&(I=rt,z=nt,o.getReversed()&&(rt=-rt,nt=-nt),i.polygonOffset(rt,nt))):kt(i.POLYGON_OFFSET_FILL)}function _n(O){O?gt(i.SCISSOR_TEST):kt(i.SCISSOR_TEST)}function en(O){O===void 0&&(O=i.TEXTURE0+X-1),j!==O&&(i.activeTexture(O),j=O)}function cn(O,rt,nt){nt===void 0&&(j===null?nt=i.TEXTURE0+X-1:nt=j);let wt=tt[nt];wt===void 0&&(wt={type:void 0,texture:void 0},tt[nt]=wt),(wt.type!==O||wt.texture!==rt)&&(j!==nt&&(i.activeTexture(nt),j=nt),i.bindTexture(O,rt||Mt[O]),wt.type=O,wt.texture=rt)}function k(){let O=tt[j];O!==void 0&&O.type!==void 0&&(i.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Ct(){try{i.compressedTexImage2D(...arguments)}catch(O){te("WebGLState:",O)}}function $t(){try{i.compressedTexImage3D(...arguments)}catch(O){te("WebGLState:",O)}}function se(){try{i.texSubImage2D(...arguments)}catch(O){te("WebGLState:",O)}}function St(){try{i.texSubImage3D(...arguments)}catch(O){te("WebGLState:",O)}}function Be(){try{i.compressedTexSubImage2D(...arguments)}catch(O){te("WebGLState:",O)}}function Vt(){try{i.compressedTexSubImage3D(...arguments)}catch(O){te("WebGLState:",O)}}function qt(){try{i.texStorage2D(...arguments)}catch(O){te("WebGLState:",O)}}function R(){try{i.texStorage3D(...arguments)}catch(O){te("WebGLState:",O)}}function b(){try{i.texImage2D(...arguments)}catch(O){te("WebGLState:",O)}}function Y(){try{i.texImage3D(...arguments)}catch(O){te("WebGLState:",O)}}function ut(O){return u[O]!==void 0?u[O]:i.getParameter(O)}function at(O,rt){u[O]!==rt&&(i.pixelStorei(O,rt),u[O]=rt)}function xt(O){Z.equals(O)===!1&&(i.scissor(O.x,O.y,O.z,O.w),Z.copy(O))}function yt(O){ft.equals(O)===!1&&(i.viewport(O.x,O.y,O.z,O.w),ft.copy(O))}function et(O,rt){let nt=c.get(rt);nt===void 0&&(nt=new WeakMap,c.set(rt,nt));let wt=nt.get(O);wt===void 0&&(wt=i.getUniformBlockIndex(rt,O.name),i.uniformBlockBinding(rt,wt,wt),nt.set(O,wt))}function st(O,rt,nt){let _t=c.get(rt).get(O);l[_t]!==nt&&(i.bindBufferBase(i.UNIFORM_BUFFER,_t,nt),l[_t]=nt)}function mt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},j=null,tt={},f={},l={},d=new WeakMap,g=[],x=null,m=!1,p=null,v=null,A=null,M=null,C=null,S=null,_=null,E=new pe(0,0,0),U=0,D=!1,L=null,B=null,F=null,I=null,z=null,Z.set(0,0,i.canvas.width,i.canvas.height),ft.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:gt,disable:kt,bindFramebuffer:Wt,drawBuffers:Nt,useProgram:ee,setBlending:Ne,setMaterial:ae,setFlipSided:Ue,setCullFace:ge,setLineWidth:Ke,setPolygonOffset:be,setScissorTest:_n,activeTexture:en,bindTexture:cn,unbindTexture:k,compressedTexImage2D:Ct,compressedTexImage3D:$t,texImage2D:b,texImage3D:Y,pixelStorei:at,getParameter:ut,updateUBOMapping:et,uniformBlockBinding:st,texStorage2D:qt,texStorage3D:R,texSubImage2D:se,texSubImage3D:St,compressedTexSubImage2D:Be,compressedTexSubImage3D:Vt,scissor:xt,viewport:yt,reset:mt}}function Mw(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new re,h=new WeakMap,u=new Set,f,d=new WeakMap,g=new Set,x=new FinalizationRegistry(R=>g.delete(R)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(R,b){return m?new OffscreenCanvas(R,b):na("canvas")}function v(R,b,Y){let ut=1,at=qt(R);if((at.width>Y||at.height>Y)&&(ut=Y/Math.max(at.width,at.height)),ut<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let xt=Math.floor(ut*at.width),yt=Math.floor(ut*at.height);f===void 0&&(f=p(xt,yt));let et=b?p(xt,yt):f;return et.width=xt,et.height=yt,et.getContext("2d").drawImage(R,0,0,xt,yt),Yt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+xt+"x"+yt+")."),et}else return"data"in R&&Yt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),R;return R}function A(R){return R.generateMipmaps}function M(R){i.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function S(R,b,Y,ut,at,xt=!1){if(R!==null){if(i[R]!==void 0)return i[R];Yt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let yt;ut&&(yt=t.get("EXT_texture_norm16"),yt||Yt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=b;if(b===i.RED&&(Y===i.FLOAT&&(et=i.R32F),Y===i.HALF_FLOAT&&(et=i.R16F),Y===i.UNSIGNED_BYTE&&(et=i.R8),Y===i.UNSIGNED_SHORT&&yt&&(et=yt.R16_EXT),Y===i.SHORT&&yt&&(et=yt.R16_SNORM_EXT)),b===i.RED_INTEGER&&(Y===i.UNSIGNED_BYTE&&(et=i.R8UI),Y===i.UNSIGNED_SHORT&&(et=i.R16UI),Y===i.UNSIGNED_INT&&(et=i.R32UI),Y===i.BYTE&&(et=i.R8I),Y===i.SHORT&&(et=i.R16I),Y===i.INT&&(et=i.R32I)),b===i.RG&&(Y===i.FLOAT&&(et=i.RG32F),Y===i.HALF_FLOAT&&(et=i.RG16F),Y===i.UNSIGNED_BYTE&&(et=i.RG8),Y===i.UNSIGNED_SHORT&&yt&&(et=yt.RG16_EXT),Y===i.SHORT&&yt&&(et=yt.RG16_SNORM_EXT)),b===i.RG_INTEGER&&(Y===i.UNSIGNED_BYTE&&(et=i.RG8UI),Y===i.UNSIGNED_SHORT&&(et=i.RG16UI),Y===i.UNSIGNED_INT&&(et=i.RG32UI),Y===i.BYTE&&(et=i.RG8I),Y===i.SHORT&&(et=i.RG16I),Y===i.INT&&(et=i.RG32I)),b===i.RGB_INTEGER&&(Y===i.UNSIGNED_BYTE&&(et=i.RGB8UI),Y===i.UNSIGNED_SHORT&&(et=i.RGB16UI),Y===i.UNSIGNED_INT&&(et=i.RGB32UI),Y===i.BYTE&&(et=i.RGB8I),Y===i.SHORT&&(et=i.RGB16I),Y===i.INT&&(et=i.RGB32I)),b===i.RGBA_INTEGER&&(Y===i.UNSIGNED_BYTE&&(et=i.RGBA8UI),Y===i.UNSIGNED_SHORT&&(et=i.RGBA16UI),Y===i.UNSIGNED_INT&&(et=i.RGBA32UI),Y===i.BYTE&&(et=i.RGBA8I),Y===i.SHORT&&(et=i.RGBA16I),Y===i.INT&&(et=i.RGBA32I)),b===i.RGB&&(Y===i.UNSIGNED_SHORT&&yt&&(et=yt.RGB16_EXT),Y===i.SHORT&&yt&&(et=yt.RGB16_SNORM_EXT),Y===i.UNSIGNED_INT_5_9_9_9_REV&&(et=i.RGB9_E5),Y===i.UNSIGNED_INT_10F_11F_11F_REV&&(et=i.R11F_G11F_B10F)),b===i.RGBA){let st=xt?ta:ye.getTransfer(at);Y===i.FLOAT&&(et=i.RGBA32F),Y===i.HALF_FLOAT&&(et=i.RGBA16F),Y===i.UNSIGNED_BYTE&&(et=st===Re?i.SRGB8_ALPHA8:i.RGBA8),Y===i.UNSIGNED_SHORT&&yt&&(et=yt.RGBA16_EXT),Y===i.SHORT&&yt&&(et=yt.RGBA16_SNORM_EXT),Y===i.UNSIGNED_SHORT_4_4_4_4&&(et=i.RGBA4),Y===i.UNSIGNED_SHORT_5_5_5_1&&(et=i.RGB5_A1)}return(et===i.R16F||et===i.R32F||et===i.RG16F||et===i.RG32F||et===i.RGBA16F||et===i.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function _(R,b){let Y;return R?b===null||b===_i||b===_r?Y=i.DEPTH24_STENCIL8:b===Ni?Y=i.DEPTH32F_STENCIL8:b===xo&&(Y=i.DEPTH24_STENCIL8,Yt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):b===null||b===_i||b===_r?Y=i.DEPTH_COMPONENT24:b===Ni?Y=i.DEPTH_COMPONENT32F:b===xo&&(Y=i.DEPTH_COMPONENT16),Y}function E(R,b){return A(R)===!0||R.isFramebufferTexture&&R.minFilter!==Rn&&R.minFilter!==qn?Math.log2(Math.max(b.width,b.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?b.mipmaps.length:1}function U(R){let b=new WeakRef(R);n.get(R).__ref=b,g.add(b),x.register(R,b,b)}function D(R){let b=n.get(R).__ref;b!==void 0&&(g.delete(b),x.unregister(b))}function L(R){F(R.target)}function B(R){I(R.target)}function F(R){R.removeEventListener("dispose",L),D(R),X(R),R.isVideoTexture&&h.delete(R),R.isHTMLTexture&&u.delete(R)}function I(R){R.removeEventListener("dispose",B),D(R),ot(R)}function z(){for(let R of g){let b=R.deref();b!==void 0&&(b.isRenderTarget===!0?I(b):F(b))}g.clear(),u.clear()}function X(R){let b=n.get(R);if(b.__webglInit===void 0)return;let Y=R.source,ut=d.get(Y);if(ut){let at=ut[b.__cacheKey];at.usedTimes--,at.usedTimes===0&&V(R),Object.keys(ut).length===0&&d.delete(Y)}n.remove(R)}function V(R){let b=n.get(R);i.deleteTexture(b.__webglTexture);let Y=R.source,ut=d.get(Y);delete ut[b.__cacheKey],o.memory.textures--}function ot(R){let b=n.get(R);b.__depthDisposeCallback&&b.__depthDisposeCallback();let Y=R.depthTexture;if(Y&&Y.renderTarget===R&&F(Y),R.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(b.__webglFramebuffer[at]))for(let xt=0;xt<b.__webglFramebuffer[at].length;xt++)i.deleteFramebuffer(b.__webglFramebuffer[at][xt]);else i.deleteFramebuffer(b.__webglFramebuffer[at]);b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer[at])}else{if(Array.isArray(b.__webglFramebuffer))for(let at=0;at<b.__webglFramebuffer.length;at++)i.deleteFramebuffer(b.__webglFramebuffer[at]);else i.deleteFramebuffer(b.__webglFramebuffer);if(b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer),b.__webglMultisampledFramebuffer&&i.deleteFramebuffer(b.__webglMultisampledFramebuffer),b.__webglColorRenderbuffer)for(let at=0;at<b.__webglColorRenderbuffer.length;at++)b.__webglColorRenderbuffer[at]&&i.deleteRenderbuffer(b.__webglColorRenderbuffer[at]);b.__webglDepthRenderbuffer&&i.deleteRenderbuffer(b.__webglDepthRenderbuffer)}let ut=R.textures;for(let at=0,xt=ut.length;at<xt;at++){let yt=n.get(ut[at]);yt.__webglTexture&&(i.deleteTexture(yt.__webglTexture),o.memory.textures--),n.remove(ut[at])}n.remove(R)}let q=0;function j(){q=0}function tt(){return q}function lt(R){q=R}function it(){let R=q;return R>=s.maxTextures&&Yt("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),q+=1,R}function Z(R){let b=[];return b.push(R.wrapS),b.push(R.wrapT),b.push(R.wrapR||0),b.push(R.magFilter),b.push(R.minFilter),b.push(R.anisotropy),b.push(R.internalFormat),b.push(R.format),b.push(R.type),b.push(R.generateMipmaps),b.push(R.mipmapsAutoUpdate),b.push(R.premultiplyAlpha),b.push(R.flipY),b.push(R.unpackAlignment),b.push(R.colorSpace),b.join()}function ft(R,b){let Y=n.get(R);if(R.isVideoTexture&&Be(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&Y.__version!==R.version){let ut=R.image;if(ut===null)Yt("WebGLRenderer: Texture marked for update but no image data found.");else if(ut.complete===!1)Yt("WebGLRenderer: Texture marked for update but image is incomplete");else{ae(Y,R,b);return}}else R.isExternalTexture&&(Y.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,Y.__webglTexture,i.TEXTURE0+b)}function dt(R,b){let Y=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&Y.__version!==R.version){ae(Y,R,b);return}else R.isExternalTexture&&(Y.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,Y.__webglTexture,i.TEXTURE0+b)}function Mt(R,b){let Y=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&Y.__version!==R.version){ae(Y,R,b);return}e.bindTexture(i.TEXTURE_3D,Y.__webglTexture,i.TEXTURE0+b)}function gt(R,b){let Y=n.get(R);if(R.version>0&&Y.__version!==R.version){Ue(Y,R,b);return}e.bindTexture(i.TEXTURE_CUBE_MAP,Y.__webglTexture,i.TEXTURE0+b)}let kt={[Xl]:i.REPEAT,[$i]:i.CLAMP_TO_EDGE,[ql]:i.MIRRORED_REPEAT},Wt={[Rn]:i.NEAREST,[fg]:i.NEAREST_MIPMAP_NEAREST,[va]:i.NEAREST_MIPMAP_LINEAR,[qn]:i.LINEAR,[vc]:i.LINEAR_MIPMAP_NEAREST,[Ms]:i.LINEAR_MIPMAP_LINEAR},Nt={[gg]:i.NEVER,[wf]:i.ALWAYS,[_g]:i.LESS,[bf]:i.LEQUAL,[xg]:i.EQUAL,[Sf]:i.GEQUAL,[yg]:i.GREATER,[vg]:i.NOTEQUAL};function ee(R,b){if(b.type===Ni&&t.has("OES_texture_float_linear")===!1&&(b.magFilter===qn||b.magFilter===vc||b.magFilter===va||b.magFilter===Ms||b.minFilter===qn||b.minFilter===vc||b.minFilter===va||b.minFilter===Ms)&&Yt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,kt[b.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,kt[b.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,kt[b.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,Wt[b.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,Wt[b.minFilter]),b.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,Nt[b.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(b.magFilter===Rn||b.minFilter!==va&&b.minFilter!==Ms||b.type===Ni&&t.has("OES_texture_float_linear")===!1)return;if(b.anisotropy>1||n.get(b).__currentAnisotropy){let Y=t.get("EXT_texture_filter_anisotropic");i.texParameterf(R,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(b.anisotropy,s.getMaxAnisotropy())),n.get(b).__currentAnisotropy=b.anisotropy}}}function jt(R,b){let Y=!1;R.__webglInit===void 0&&(R.__webglInit=!0,b.addEventListener("dispose",L),U(b));let ut=b.source,at=d.get(ut);at===void 0&&(at={},d.set(ut,at));let xt=Z(b);if(xt!==R.__cacheKey){at[xt]===void 0&&(at[xt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),at[xt].usedTimes++;let yt=at[R.__cacheKey];yt!==void 0&&(at[R.__cacheKey].usedTimes--,yt.usedTimes===0&&V(b)),R.__cacheKey=xt,R.__webglTexture=at[xt].texture}return Y}function Xt(R,b,Y){return Math.floor(Math.floor(R/Y)/b)}function Ne(R,b,Y,ut){let xt=R.updateRanges;if(xt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,b.width,b.height,Y,ut,b.data);else{xt.sort((O,rt)=>O.start-rt.start);let yt=0;for(let O=1;O<xt.length;O++){let rt=xt[yt],nt=xt[O],wt=rt.start+rt.count,_t=Xt(nt.start,b.width,4),bt=Xt(rt.start,b.width,4);nt.start<=wt+1&&_t===bt&&Xt(nt.start+nt.count-1,b.width,4)===_t?rt.count=Math.max(rt.count,nt.start+nt.count-rt.start):(++yt,xt[yt]=nt)}xt.length=yt+1;let et=e.getParameter(i.UNPACK_ROW_LENGTH),st=e.getParameter(i.UNPACK_SKIP_PIXELS),mt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,b.width);for(let O=0,rt=xt.length;O<rt;O++){let nt=xt[O],wt=Math.floor(nt.start/4),_t=Math.ceil(nt.count/4),bt=wt%b.width,Gt=Math.floor(wt/b.width),Jt=_t,ht=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(i.UNPACK_SKIP_ROWS,Gt),e.texSubImage2D(i.TEXTURE_2D,0,bt,Gt,Jt,ht,Y,ut,b.data)}R.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,et),e.pixelStorei(i.UNPACK_SKIP_PIXELS,st),e.pixelStorei(i.UNPACK_SKIP_ROWS,mt)}}function ae(R,b,Y){let ut=i.TEXTURE_2D;(b.isDataArrayTexture||b.isCompressedArrayTexture)&&(ut=i.TEXTURE_2D_ARRAY),b.isData3DTexture&&(ut=i.TEXTURE_3D);let at=jt(R,b),xt=b.source;e.bindTexture(ut,R.__webglTexture,i.TEXTURE0+Y);let yt=n.get(xt);if(xt.version!==yt.__version||at===!0){if(e.activeTexture(i.TEXTURE0+Y),(typeof ImageBitmap<"u"&&b.image instanceof ImageBitmap)===!1){let ht=ye.getPrimaries(ye.workingColorSpace),Ot=b.colorSpace===Ss?null:ye.getPrimaries(b.colorSpace),Kt=b.colorSpace===Ss||ht===Ot?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Kt)}e.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment);let st=v(b.image,!1,s.maxTextureSize);st=Vt(b,st);let mt=r.convert(b.format,b.colorSpace),O=r.convert(b.type),rt=S(b.internalFormat,mt,O,b.normalized,b.colorSpace,b.isVideoTexture);ee(ut,b);let nt,wt=b.mipmaps,_t=b.isVideoTexture!==!0,bt=yt.__version===void 0||at===!0,Gt=xt.dataReady,Jt=E(b,st);if(b.isDepthTexture)rt=_(b.format===bs,b.type),bt&&(_t?e.texStorage2D(i.TEXTURE_2D,1,rt,st.width,st.height):e.texImage2D(i.TEXTURE_2D,0,rt,st.width,st.height,0,mt,O,null));else if(b.isDataTexture)if(wt.length>0){_t&&bt&&e.texStorage2D(i.TEXTURE_2D,Jt,rt,wt[0].width,wt[0].height);for(let ht=0,Ot=wt.length;ht<Ot;ht++)nt=wt[ht],_t?Gt&&e.texSubImage2D(i.TEXTURE_2D,ht,0,0,nt.width,nt.height,mt,O,nt.data):e.texImage2D(i.TEXTURE_2D,ht,rt,nt.width,nt.height,0,mt,O,nt.data);b.generateMipmaps=!1}else _t?(bt&&e.texStorage2D(i.TEXTURE_2D,Jt,rt,st.width,st.height),Gt&&Ne(b,st,mt,O)):e.texImage2D(i.TEXTURE_2D,0,rt,st.width,st.height,0,mt,O,st.data);else if(b.isCompressedTexture)if(b.isCompressedArrayTexture){_t&&bt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Jt,rt,wt[0].width,wt[0].height,st.depth);for(let ht=0,Ot=wt.length;ht<Ot;ht++)if(nt=wt[ht],b.format!==Fi)if(mt!==null)if(_t){if(Gt)if(b.layerUpdates.size>0){let Kt=Nf(nt.width,nt.height,b.format,b.type);for(let At of b.layerUpdates){let oe=nt.data.subarray(At*Kt/nt.data.BYTES_PER_ELEMENT,(At+1)*Kt/nt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ht,0,0,At,nt.width,nt.height,1,mt,oe)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ht,0,0,0,nt.width,nt.height,st.depth,mt,nt.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ht,rt,nt.width,nt.height,st.depth,0,nt.data,0,0);else Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _t?Gt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ht,0,0,0,nt.width,nt.height,st.depth,mt,O,nt.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ht,rt,nt.width,nt.height,st.depth,0,mt,O,nt.data);b.layerUpdates.size>0&&b.clearLayerUpdates()}else{_t&&bt&&e.texStorage2D(i.TEXTURE_2D,Jt,rt,wt[0].width,wt[0].height);for(let ht=0,Ot=wt.length;ht<Ot;ht++)nt=wt[ht],b.format!==Fi?mt!==null?_t?Gt&&e.compressedTexSubImage2D(i.TEXTURE_2D,ht,0,0,nt.width,nt.height,mt,nt.data):e.compressedTexImage2D(i.TEXTURE_2D,ht,rt,nt.width,nt.height,0,nt.data):Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_t?Gt&&e.texSubImage2D(i.TEXTURE_2D,ht,0,0,nt.width,nt.height,mt,O,nt.data):e.texImage2D(i.TEXTURE_2D,ht,rt,nt.width,nt.height,0,mt,O,nt.data)}else if(b.isDataArrayTexture)if(_t){if(bt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Jt,rt,st.width,st.height,st.depth),Gt)if(b.layerUpdates.size>0){let ht=Nf(st.width,st.height,b.format,b.type);for(let Ot of b.layerUpdates){let Kt=st.data.subarray(Ot*ht/st.data.BYTES_PER_ELEMENT,(Ot+1)*ht/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Ot,st.width,st.height,1,mt,O,Kt)}b.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,mt,O,st.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,rt,st.width,st.height,st.depth,0,mt,O,st.data);else if(b.isData3DTexture)_t?(bt&&e.texStorage3D(i.TEXTURE_3D,Jt,rt,st.width,st.height,st.depth),Gt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,mt,O,st.data)):e.texImage3D(i.TEXTURE_3D,0,rt,st.width,st.height,st.depth,0,mt,O,st.data);else if(b.isFramebufferTexture){if(bt)if(_t)e.texStorage2D(i.TEXTURE_2D,Jt,rt,st.width,st.height);else{let ht=st.width,Ot=st.height;for(let Kt=0;Kt<Jt;Kt++)e.texImage2D(i.TEXTURE_2D,Kt,rt,ht,Ot,0,mt,O,null),ht>>=1,Ot>>=1}}else if(b.isHTMLTexture){if("texElementImage2D"in i){let ht=i.canvas;if(ht.hasAttribute("layoutsubtree")||ht.setAttribute("layoutsubtree","true"),st.parentNode!==ht){ht.appendChild(st),u.add(b),ht.onpaint=Ot=>{let Kt=Ot.changedElements;for(let At of u)Kt.includes(At.image)&&(At.needsUpdate=!0)},ht.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,st);else{let Kt=i.RGBA,At=i.RGBA,oe=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Kt,At,oe,st)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(wt.length>0){if(_t&&bt){let ht=qt(wt[0]);e.texStorage2D(i.TEXTURE_2D,Jt,rt,ht.width,ht.height)}for(let ht=0,Ot=wt.length;ht<Ot;ht++)nt=wt[ht],_t?Gt&&e.texSubImage2D(i.TEXTURE_2D,ht,0,0,mt,O,nt):e.texImage2D(i.TEXTURE_2D,ht,rt,mt,O,nt);b.generateMipmaps=!1}else if(_t){if(bt){let ht=qt(st);e.texStorage2D(i.TEXTURE_2D,Jt,rt,ht.width,ht.height)}Gt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,mt,O,st)}else e.texImage2D(i.TEXTURE_2D,0,rt,mt,O,st);A(b)&&b.mipmapsAutoUpdate===!0&&M(ut),yt.__version=xt.version,b.onUpdate&&b.onUpdate(b)}R.__version=b.version}function Ue(R,b,Y){if(b.image.length!==6)return;let ut=jt(R,b),at=b.source;e.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+Y);let xt=n.get(at);if(at.version!==xt.__version||ut===!0){e.activeTexture(i.TEXTURE0+Y);let yt=ye.getPrimaries(ye.workingColorSpace),et=b.colorSpace===Ss?null:ye.getPrimaries(b.colorSpace),st=b.colorSpace===Ss||yt===et?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let mt=b.isCompressedTexture||b.image[0].isCompressedTexture,O=b.image[0]&&b.image[0].isDataTexture,rt=[];for(let At=0;At<6;At++)!mt&&!O?rt[At]=v(b.image[At],!0,s.maxCubemapSize):rt[At]=O?b.image[At].image:b.image[At],rt[At]=Vt(b,rt[At]);let nt=rt[0],wt=r.convert(b.format,b.colorSpace),_t=r.convert(b.type),bt=S(b.internalFormat,wt,_t,b.normalized,b.colorSpace),Gt=b.isVideoTexture!==!0,Jt=xt.__version===void 0||ut===!0,ht=at.dataReady,Ot=E(b,nt);ee(i.TEXTURE_CUBE_MAP,b);let Kt;if(b.isDepthTexture){if(bt=_(b.format===bs,b.type),Jt)if(Gt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,bt,nt.width,nt.height);else for(let At=0;At<6;At++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+At,0,bt,nt.width,nt.height,0,wt,_t,null)}else if(mt){Gt&&Jt&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Ot,bt,nt.width,nt.height);for(let At=0;At<6;At++){Kt=rt[At].mipmaps;for(let oe=0;oe<Kt.length;oe++){let He=Kt[oe];b.format!==Fi?wt!==null?Gt?ht&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+At,oe,0,0,He.width,He.height,wt,He.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+At,oe,bt,He.width,He.height,0,He.data):Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Gt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+At,oe,0,0,He.width,He.height,wt,_t,He.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+At,oe,bt,He.width,He.height,0,wt,_t,He.data)}}}else{if(Kt=b.mipmaps,Gt&&Jt){Kt.length>0&&Ot++;let At=qt(rt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Ot,bt,At.width,At.height)}for(let At=0;At<6;At++)if(O){Gt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+At,0,0,0,rt[At].width,rt[At].height,wt,_t,rt[At].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+At,0,bt,rt[At].width,rt[At].height,0,wt,_t,rt[At].data);for(let oe=0;oe<Kt.length;oe++){let Bn=Kt[oe].image[At].image;Gt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+At,oe+1,0,0,Bn.width,Bn.height,wt,_t,Bn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+At,oe+1,bt,Bn.width,Bn.height,0,wt,_t,Bn.data)}}else{Gt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+At,0,0,0,wt,_t,rt[At]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+At,0,bt,wt,_t,rt[At]);for(let oe=0;oe<Kt.length;oe++){let He=Kt[oe];Gt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+At,oe+1,0,0,wt,_t,He.image[At]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+At,oe+1,bt,wt,_t,He.image[At])}}}A(b)&&b.mipmapsAutoUpdate===!0&&M(i.TEXTURE_CUBE_MAP),xt.__version=at.version,b.onUpdate&&b.onUpdate(b)}R.__version=b.version}function ge(R,b,Y,ut,at,xt){let yt=r.convert(Y.format,Y.colorSpace),et=r.convert(Y.type),st=S(Y.internalFormat,yt,et,Y.normalized,Y.colorSpace),mt=n.get(b),O=n.get(Y);if(O.__renderTarget=b,!mt.__hasExternalTextures){let rt=Math.max(1,b.width>>xt),nt=Math.max(1,b.height>>xt);at===i.TEXTURE_3D||at===i.TEXTURE_2D_ARRAY?e.texImage3D(at,xt,st,rt,nt,b.depth,0,yt,et,null):e.texImage2D(at,xt,st,rt,nt,0,yt,et,null)}e.bindFramebuffer(i.FRAMEBUFFER,R),St(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ut,at,O.__webglTexture,0,se(b)):(at===i.TEXTURE_2D||at>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ut,at,O.__webglTexture,xt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Ke(R,b,Y){if(i.bindRenderbuffer(i.RENDERBUFFER,R),b.depthBuffer){let ut=b.depthTexture,at=ut&&ut.isDepthTexture?ut.type:null,xt=_(b.stencilBuffer,at),yt=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;St(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,se(b),xt,b.width,b.height):Y?i.renderbufferStorageMultisample(i.RENDERBUFFER,se(b),xt,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,xt,b.width,b.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,yt,i.RENDERBUFFER,R)}else{let ut=b.textures;for(let at=0;at<ut.length;at++){let xt=ut[at],yt=r.convert(xt.format,xt.colorSpace),et=r.convert(xt.type),st=S(xt.internalFormat,yt,et,xt.normalized,xt.colorSpace);St(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,se(b),st,b.width,b.height):Y?i.renderbufferStorageMultisample(i.RENDERBUFFER,se(b),st,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,st,b.width,b.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function be(R,b,Y){let ut=b.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,R),!(b.depthTexture&&b.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=n.get(b.depthTexture);at.__renderTarget=b;let xt=ut?b.depthTexture.image[0]:b.depthTexture.image;(!at.__webglTexture||xt.width!==b.width||xt.height!==b.height)&&(xt.width=b.width,xt.height=b.height,b.depthTexture.needsUpdate=!0),ut?gt(b.depthTexture,0):ft(b.depthTexture,0);let yt=at.__webglTexture,et=se(b),st=ut?i.TEXTURE_CUBE_MAP_POSITIVE_X+Y:i.TEXTURE_2D,mt=b.depthTexture.format===bs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(b.depthTexture.format===_s)St(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,st,yt,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,mt,st,yt,0);else if(b.depthTexture.format===bs)St(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,st,yt,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,mt,st,yt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function _n(R){let b=n.get(R),Y=R.isWebGLCubeRenderTarget===!0;if(b.__boundDepthTexture!==R.depthTexture){let ut=R.depthTexture;if(b.__depthDisposeCallback&&b.__depthDisposeCallback(),ut){let at=()=>{delete b.__boundDepthTexture,delete b.__depthDisposeCallback,ut.removeEventListener("dispose",at)};ut.addEventListener("dispose",at),b.__depthDisposeCallback=at}b.__boundDepthTexture=ut}if(R.depthTexture&&!b.__autoAllocateDepthBuffer)if(Y)for(let ut=0;ut<6;ut++)be(b.__webglFramebuffer[ut],R,ut);else R.texture.mipmaps.length>0?be(b.__webglFramebuffer[0],R,0):be(b.__webglFramebuffer,R,0);else if(Y){b.__webglDepthbuffer=[];for(let ut=0;ut<6;ut++)if(e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[ut]),b.__webglDepthbuffer[ut]===void 0)b.__webglDepthbuffer[ut]=i.createRenderbuffer(),Ke(b.__webglDepthbuffer[ut],R,!1);else{let at=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xt=b.__webglDepthbuffer[ut];i.bindRenderbuffer(i.RENDERBUFFER,xt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,xt)}}else if(R.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer),b.__webglDepthbuffer===void 0)b.__webglDepthbuffer=i.createRenderbuffer(),Ke(b.__webglDepthbuffer,R,!1);else{let at=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xt=b.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,xt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,xt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function en(R,b,Y){let ut=n.get(R);b!==void 0&&ge(ut.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Y!==void 0&&_n(R)}function cn(R){let b=R.texture,Y=n.get(R),ut=n.get(b);R.addEventListener("dispose",B),U(R);let at=R.textures,xt=R.isWebGLCubeRenderTarget===!0,yt=at.length>1;if(yt||(ut.__webglTexture===void 0&&(ut.__webglTexture=i.createTexture()),ut.__version=b.version,o.memory.textures++),xt){Y.__webglFramebuffer=[];for(let et=0;et<6;et++)if(b.mipmaps.length>0){Y.__webglFramebuffer[et]=[];for(let st=0;st<b.mipmaps.length;st++)Y.__webglFramebuffer[et][st]=i.createFramebuffer()}else Y.__webglFramebuffer[et]=i.createFramebuffer()}else{if(b.mipmaps.length>0){Y.__webglFramebuffer=[];for(let et=0;et<b.mipmaps.length;et++)Y.__webglFramebuffer[et]=i.createFramebuffer()}else Y.__webglFramebuffer=i.createFramebuffer();if(yt)for(let et=0,st=at.length;et<st;et++){let mt=n.get(at[et]);mt.__webglTexture===void 0&&(mt.__webglTexture=i.createTexture(),o.memory.textures++)}if(R.samples>0&&St(R)===!1){Y.__webglMultisampledFramebuffer=i.createFramebuffer(),Y.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let et=0;et<at.length;et++){let st=at[et];Y.__webglColorRenderbuffer[et]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Y.__webglColorRenderbuffer[et]);let mt=r.convert(st.format,st.colorSpace),O=r.convert(st.type),rt=S(st.internalFormat,mt,O,st.normalized,st.colorSpace,R.isXRRenderTarget===!0),nt=se(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,nt,rt,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+et,i.RENDERBUFFER,Y.__webglColorRenderbuffer[et])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(Y.__webglDepthRenderbuffer=i.createRenderbuffer(),Ke(Y.__webglDepthRenderbuffer,R,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(xt){e.bindTexture(i.TEXTURE_CUBE_MAP,ut.__webglTexture),ee(i.TEXTURE_CUBE_MAP,b);for(let et=0;et<6;et++)if(b.mipmaps.length>0)for(let st=0;st<b.mipmaps.length;st++)ge(Y.__webglFramebuffer[et][st],R,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+et,st);else ge(Y.__webglFramebuffer[et],R,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);A(b)?M(i.TEXTURE_CUBE_MAP):b.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}else if(yt){for(let et=0,st=at.length;et<st;et++){let mt=at[et],O=n.get(mt),rt=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(rt=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(rt,O.__webglTexture),ee(rt,mt),ge(Y.__webglFramebuffer,R,mt,i.COLOR_ATTACHMENT0+et,rt,0),A(mt)&&M(rt)}e.unbindTexture()}else{let et=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(et=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(et,ut.__webglTexture),ee(et,b),b.mipmaps.length>0)for(let st=0;st<b.mipmaps.length;st++)ge(Y.__webglFramebuffer[st],R,b,i.COLOR_ATTACHMENT0,et,st);else ge(Y.__webglFramebuffer,R,b,i.COLOR_ATTACHMENT0,et,0);A(b)?M(et):b.mipmaps.length>0&&i.texParameteri(et,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}R.depthBuffer&&_n(R)}function k(R){let b=R.textures;for(let Y=0,ut=b.length;Y<ut;Y++){let at=b[Y];if(A(at)&&at.mipmapsAutoUpdate===!0){let xt=C(R),yt=n.get(at).__webglTexture;e.bindTexture(xt,yt),M(xt),e.unbindTexture()}}}let Ct=[];function $t(R){if(R.samples>0){if(St(R)===!1){let b=R.textures,Y=R.width,ut=R.height,at=i.COLOR_BUFFER_BIT,xt=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=n.get(R),et=b.length>1;if(et)for(let mt=0;mt<b.length;mt++)e.bindFramebuffer(i.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,yt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,yt.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,yt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,yt.__webglFramebuffer);for(let mt=0;mt<b.length;mt++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(at|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(at|=i.STENCIL_BUFFER_BIT)),et){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let O=n.get(b[mt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,O,0)}i.blitFramebuffer(0,0,Y,ut,0,0,Y,ut,at,i.NEAREST),l===!0&&(Ct.length=0,Ct.push(i.COLOR_ATTACHMENT0+mt),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Ct.push(xt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ct))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),et)for(let mt=0;mt<b.length;mt++){e.bindFramebuffer(i.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let O=n.get(b[mt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,yt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,O,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,yt.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let b=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[b])}}}function se(R){return Math.min(s.maxSamples,R.samples)}function St(R){let b=n.get(R);return R.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&b.__useRenderToTexture!==!1}function Be(R){let b=o.render.frame;h.get(R)!==b&&(h.set(R,b),R.update())}function Vt(R,b){let Y=R.colorSpace,ut=R.format,at=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||Y!==Qo&&Y!==Ss&&(ye.getTransfer(Y)===Re?(ut!==Fi||at!==gi)&&Yt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):te("WebGLTextures: Unsupported texture color space:",Y)),b}function qt(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=it,this.resetTextureUnits=j,this.getTextureUnits=tt,this.setTextureUnits=lt,this.setTexture2D=ft,this.setTexture2DArray=dt,this.setTexture3D=Mt,this.setTextureCube=gt,this.rebindTextures=en,this.setupRenderTarget=cn,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=$t,this.setupDepthRenderbuffer=_n,this.setupFrameBufferTexture=ge,this.useMultisampledRTT=St,this.dispose=z}function bw(i,t){function e(n,s=Ss){let r,o=ye.getTransfer(s);if(n===gi)return i.UNSIGNED_BYTE;if(n===bc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Sc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===gf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===_f)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===pf)return i.BYTE;if(n===mf)return i.SHORT;if(n===xo)return i.UNSIGNED_SHORT;if(n===Mc)return i.INT;if(n===_i)return i.UNSIGNED_INT;if(n===Ni)return i.FLOAT;if(n===Ui)return i.HALF_FLOAT;if(n===xf)return i.ALPHA;if(n===yf)return i.RGB;if(n===Fi)return i.RGBA;if(n===_s)return i.DEPTH_COMPONENT;if(n===bs)return i.DEPTH_STENCIL;if(n===vf)return i.RED;if(n===yo)return i.RED_INTEGER;if(n===Zs)return i.RG;if(n===wc)return i.RG_INTEGER;if(n===Ec)return i.RGBA_INTEGER;if(n===Ma||n===ba||n===Sa||n===wa)if(o===Re)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ma)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ba)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Sa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ma)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ba)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Sa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===wa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Tc||n===Ac||n===Cc||n===Rc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Tc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Ac)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Cc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Rc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Pc||n===Ic||n===Lc||n===Dc||n===Nc||n===Ea||n===Uc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Pc||n===Ic)return o===Re?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Lc)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Dc)return r.COMPRESSED_R11_EAC;if(n===Nc)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ea)return r.COMPRESSED_RG11_EAC;if(n===Uc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Fc||n===Oc||n===Bc||n===kc||n===zc||n===Vc||n===Gc||n===Hc||n===Wc||n===Xc||n===qc||n===Yc||n===$c||n===Zc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Fc)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Oc)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Bc)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===kc)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===zc)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Vc)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Gc)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Hc)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Wc)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Xc)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===qc)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Yc)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===$c)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Zc)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Jc||n===Kc||n===jc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Jc)return o===Re?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Kc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===jc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Qc||n===th||n===Ta||n===eh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Qc)return r.COMPRESSED_RED_RGTC1_EXT;if(n===th)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ta)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===eh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===_r?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var Sw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,ww=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Hf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new ua(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new Pn({vertexShader:Sw,fragmentShader:ww,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new tn(new fa(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Wf=class extends Di{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,d=null,g=null,x=typeof XRWebGLBinding<"u",m=new Hf,p={},v=e.getContextAttributes(),A=null,M=null,C=[],S=[],_=new re,E=null,U=null,D=new Xn;D.viewport=new De;let L=new Xn;L.viewport=new De;let B=[D,L],F=new _c,I=null,z=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Z){let ft=C[Z];return ft===void 0&&(ft=new co,C[Z]=ft),ft.getTargetRaySpace()},this.getControllerGrip=function(Z){let ft=C[Z];return ft===void 0&&(ft=new co,C[Z]=ft),ft.getGripSpace()},this.getHand=function(Z){let ft=C[Z];return ft===void 0&&(ft=new co,C[Z]=ft),ft.getHandSpace()};function X(Z){let ft=S.indexOf(Z.inputSource);if(ft===-1)return;let dt=C[ft];dt!==void 0&&(dt.update(Z.inputSource,Z.frame,c||o),dt.dispatchEvent({type:Z.type,data:Z.inputSource}))}function V(){s.removeEventListener("select",X),s.removeEventListener("selectstart",X),s.removeEventListener("selectend",X),s.removeEventListener("squeeze",X),s.removeEventListener("squeezestart",X),s.removeEventListener("squeezeend",X),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",ot);for(let Z=0;Z<C.length;Z++){let ft=S[Z];ft!==null&&(S[Z]=null,C[Z].disconnect(ft))}I=null,z=null,m.reset();for(let Z in p)delete p[Z];if(t.setRenderTarget(A),d=null,f=null,u=null,s=null,M=null,it.stop(),n.isPresenting=!1,t.setPixelRatio(E),t.setSize(_.width,_.height,!1),U!==null){let Z=U.camera;Z.fov=U.fov,Z.zoom=U.zoom,Z.updateProjectionMatrix(),U=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Z){r=Z,n.isPresenting===!0&&Yt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Z){a=Z,n.isPresenting===!0&&Yt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Z){c=Z},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Z){if(s=Z,s!==null){if(A=t.getRenderTarget(),s.addEventListener("select",X),s.addEventListener("selectstart",X),s.addEventListener("selectend",X),s.addEventListener("squeeze",X),s.addEventListener("squeezestart",X),s.addEventListener("squeezeend",X),s.addEventListener("end",V),s.addEventListener("inputsourceschange",ot),v.xrCompatible!==!0&&await e.makeXRCompatible(),E=t.getPixelRatio(),t.getSize(_),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let dt=null,Mt=null,gt=null;v.depth&&(gt=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,dt=v.stencil?bs:_s,Mt=v.stencil?_r:_i);let kt={colorFormat:e.RGBA8,depthFormat:gt,scaleFactor:r};u=this.getBinding(),f=u.createProjectionLayer(kt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),M=new pi(f.textureWidth,f.textureHeight,{format:Fi,type:gi,depthTexture:new vs(f.textureWidth,f.textureHeight,Mt,void 0,void 0,void 0,void 0,void 0,void 0,dt),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let dt={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,dt),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),M=new pi(d.framebufferWidth,d.framebufferHeight,{format:Fi,type:gi,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),it.setContext(s),it.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ot(Z){for(let ft=0;ft<Z.removed.length;ft++){let dt=Z.removed[ft],Mt=S.indexOf(dt);Mt>=0&&(S[Mt]=null,C[Mt].disconnect(dt))}for(let ft=0;ft<Z.added.length;ft++){let dt=Z.added[ft],Mt=S.indexOf(dt);if(Mt===-1){for(let kt=0;kt<C.length;kt++)if(kt>=S.length){S.push(dt),Mt=kt;break}else if(S[kt]===null){S[kt]=dt,Mt=kt;break}if(Mt===-1)break}let gt=C[Mt];gt&&gt.connect(dt)}}function q(Z,ft){ft===null?Z.matrixWorld.copy(Z.matrix):Z.matrixWorld.multiplyMatrices(ft.matrixWorld,Z.matrix),Z.matrixWorldInverse.copy(Z.matrixWorld).invert()}this.updateCamera=function(Z){if(s===null)return;let ft=Z.near,dt=Z.far;m.texture!==null&&(m.depthNear>0&&(ft=m.depthNear),m.depthFar>0&&(dt=m.depthFar)),F.near=L.near=D.near=ft,F.far=L.far=D.far=dt,(I!==F.near||z!==F.far)&&(s.updateRenderState({depthNear:F.near,depthFar:F.far}),I=F.near,z=F.far),F.layers.mask=Z.layers.mask|6,D.layers.mask=F.layers.mask&-5,L.layers.mask=F.layers.mask&-3;let Mt=Z.parent,gt=F.cameras;q(F,Mt);for(let kt=0;kt<gt.length;kt++)q(gt[kt],Mt);F.projectionMatrix.copy(D.projectionMatrix),F.projectionMatrixInverse.copy(D.projectionMatrixInverse),U===null&&Z.isPerspectiveCamera&&(U={camera:Z,fov:Z.fov,zoom:Z.zoom}),j(Z,F,Mt)};function j(Z,ft,dt){dt===null?Z.matrix.copy(ft.matrixWorld):(Z.matrix.copy(dt.matrixWorld),Z.matrix.invert(),Z.matrix.multiply(ft.matrixWorld)),Z.matrix.decompose(Z.position,Z.quaternion,Z.scale),Z.updateMatrixWorld(!0),Z.projectionMatrix.copy(ft.projectionMatrix),Z.projectionMatrixInverse.copy(ft.projectionMatrixInverse),Z.isPerspectiveCamera&&(Z.fov=ao*2*Math.atan(1/Z.projectionMatrix.elements[5]),Z.zoom=1)}this.getCamera=function(){return F},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(Z){l=Z,f!==null&&(f.fixedFoveation=Z),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=Z)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(F)},this.getCameraTexture=function(Z){return p[Z]};let tt=null;function lt(Z,ft){if(h=ft.getViewerPose(c||o),g=ft,h!==null){let dt=h.views;d!==null&&(t.setRenderTargetFramebuffer(M,d.framebuffer),t.setRenderTarget(M));let Mt=!1;dt.length!==F.cameras.length&&(F.cameras.length=0,Mt=!0);for(let Nt=0;Nt<dt.length;Nt++){let ee=dt[Nt],jt=null;if(d!==null)jt=d.getViewport(ee);else{let Ne=u.getViewSubImage(f,ee);jt=Ne.viewport,Nt===0&&(t.setRenderTargetTextures(M,Ne.colorTexture,Ne.depthStencilTexture),t.setRenderTarget(M))}let Xt=B[Nt];Xt===void 0&&(Xt=new Xn,Xt.layers.enable(Nt),Xt.viewport=new De,B[Nt]=Xt),Xt.matrix.fromArray(ee.transform.matrix),Xt.matrix.decompose(Xt.position,Xt.quaternion,Xt.scale),Xt.projectionMatrix.fromArray(ee.projectionMatrix),Xt.projectionMatrixInverse.copy(Xt.projectionMatrix).invert(),Xt.viewport.set(jt.x,jt.y,jt.width,jt.height),Nt===0&&(F.matrix.copy(Xt.matrix),F.matrix.decompose(F.position,F.quaternion,F.scale)),Mt===!0&&F.cameras.push(Xt)}let gt=s.enabledFeatures;if(gt&&gt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=n.getBinding();let Nt=u.getDepthInformation(dt[0]);Nt&&Nt.isValid&&Nt.texture&&m.init(Nt,s.renderState)}if(gt&&gt.includes("camera-access")&&x){t.state.unbindTexture(),u=n.getBinding();for(let Nt=0;Nt<dt.length;Nt++){let ee=dt[Nt].camera;if(ee){let jt=p[ee];jt||(jt=new ua,p[ee]=jt);let Xt=u.getCameraImage(ee);jt.sourceTexture=Xt}}}}for(let dt=0;dt<C.length;dt++){let Mt=S[dt],gt=C[dt];Mt!==null&&gt!==void 0&&gt.update(Mt,ft,c||o)}tt&&tt(Z,ft),ft.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ft}),g=null}let it=new Qg;it.setAnimationLoop(lt),this.setAnimationLoop=function(Z){tt=Z},this.dispose=function(){}}},Ew=new Je,c0=new ne;c0.set(-1,0,0,0,1,0,0,0,1);function Tw(i,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,If(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,v,A,M){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(m,p):p.isMeshLambertMaterial?(r(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(m,p),u(m,p)):p.isMeshPhongMaterial?(r(m,p),h(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(m,p),f(m,p),p.isMeshPhysicalMaterial&&d(m,p,M)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),x(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,v,A):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Zn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Zn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let v=t.get(p),A=v.envMap,M=v.envMapRotation;A&&(m.envMap.value=A,m.envMapRotation.value.setFromMatrix4(Ew.makeRotationFromEuler(M)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(c0),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,v,A){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*v,m.scale.value=A*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function h(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function u(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function f(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,v){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Zn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function x(m,p){let v=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function Aw(i,t,e,n){let s={},r={};function o(v,A){let M=A.program;n.uniformBlockBinding(v,M,s[v.id])}function a(v,A){let M=s[v.id];M===void 0&&(g(v),M=l(v),s[v.id]=M,v.addEventListener("dispose",m));let C=A.program;n.updateUBOMapping(v,C);let S=t.render.frame;r[v.id]!==S&&(c(v),r[v.id]=S)}function l(v){let A=i.createBuffer(),M=v.__size,C=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,M,C),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function c(v){let A=s[v.id],M=v.uniforms,C=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let S=0,_=M.length;S<_;S++){let E=M[S];if(Array.isArray(E))for(let U=0,D=E.length;U<D;U++)h(E[U],S,U,C);else h(E,S,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,A,M,C){if(f(v,A,M,C)===!0){let S=v.__offset,_=v.value;if(Array.isArray(_)){let E=0;for(let U=0;U<_.length;U++){let D=_[U],L=x(D,!0);u(D,v.__data,E),E+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else u(_,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,S,v.__data)}}function u(v,A,M){typeof v=="number"||typeof v=="boolean"?A[M]=v:v.isMatrix3?(A[M]=v.elements[0],A[M+1]=v.elements[1],A[M+2]=v.elements[2],A[M+3]=0,A[M+4]=v.elements[3],A[M+5]=v.elements[4],A[M+6]=v.elements[5],A[M+7]=0,A[M+8]=v.elements[6],A[M+9]=v.elements[7],A[M+10]=v.elements[8],A[M+11]=0):ArrayBuffer.isView(v)?A.set(v.subarray(0,A.length-M),M):v.toArray(A,M)}function f(v,A,M,C){let S=v.value,_=A+"_"+M;if(Array.isArray(S)){C[_]===void 0&&(C[_]=[]);let E=C[_],U=!1;for(let D=0;D<S.length;D++)d(S[D],E,D)===!0&&(U=!0);return U}return d(S,C,_)}function d(v,A,M){if(A[M]===void 0)return typeof v=="number"||typeof v=="boolean"?A[M]=v:ArrayBuffer.isView(v)?A[M]=v.slice():A[M]=v.clone(),!0;{let C=A[M];if(typeof v=="number"||typeof v=="boolean"){if(C!==v)return A[M]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(C.equals(v)===!1)return C.copy(v),!0}}return!1}function g(v){let A=v.uniforms,M=0,C=16;for(let _=0,E=A.length;_<E;_++){let U=Array.isArray(A[_])?A[_]:[A[_]];for(let D=0,L=U.length;D<L;D++){let B=U[D],F=Array.isArray(B.value)?B.value:[B.value],I=Array.isArray(A[_])||Array.isArray(B.value),z=M;for(let V=0,ot=F.length;V<ot;V++){let q=F[V],j=x(q,I),tt=M%C,lt=tt%j.boundary,it=tt+lt;M+=lt,it!==0&&C-it<j.storage&&(M+=C-it),V===0&&(z=M),M+=j.storage}let X=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new X((M-z)/Float32Array.BYTES_PER_ELEMENT),B.__offset=z}}let S=M%C;return S>0&&(M+=C-S),v.__size=M,v.__cache={},this}function x(v,A){let M={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(M.boundary=4,M.storage=4):v.isVector2?(M.boundary=8,M.storage=8):v.isVector3||v.isColor?(M.boundary=16,M.storage=12):v.isVector4?(M.boundary=16,M.storage=16):v.isMatrix3?(M.boundary=16,M.storage=48):v.isMatrix4?(M.boundary=16,M.storage=64):v.isTexture?Yt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(M.boundary=16,M.storage=v.byteLength):Yt("WebGLRenderer: Unsupported uniform value type.",v),A===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function m(v){let A=v.target;A.removeEventListener("dispose",m),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function p(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:p}}var Cw=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ji=null;function Rw(){return ji===null&&(ji=new ho(Cw,16,16,Zs,Ui),ji.name="DFG_LUT",ji.minFilter=qn,ji.magFilter=qn,ji.wrapS=$i,ji.wrapT=$i,ji.generateMipmaps=!1,ji.needsUpdate=!0),ji}var rh=class{constructor(t={}){let{canvas:e=bg(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1,outputBufferType:d=gi}=t;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let x=d,m=new Set([Ec,wc,yo]),p=new Set([gi,_i,xo,_r,bc,Sc]),v=new Uint32Array(4),A=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},C=null,S=null,_=[],E=[],U=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ki,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let D=this,L=!1,B=null,F=null,I=null,z=null;this._outputColorSpace=fi;let X=0,V=0,ot=null,q=-1,j=null,tt=new De,lt=new De,it=null,Z=new pe(0),ft=0,dt=e.width,Mt=e.height,gt=1,kt=null,Wt=null,Nt=new De(0,0,dt,Mt),ee=new De(0,0,dt,Mt),jt=!1,Xt=new dr,Ne=new Kl,ae=!1,Ue=!1,ge=new Je,Ke=new W,be=new De,_n={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},en=!1;function cn(){return ot===null?gt:1}let k=n;function Ct(T,G){return e.getContext(T,G)}let $t,se,St,Be,Vt,qt,R,b,Y,ut,at,xt,yt,et,st,mt,O,rt,nt,wt,_t,bt,Gt;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ot,!1),e.addEventListener("webglcontextrestored",Kt,!1),e.addEventListener("webglcontextcreationerror",At,!1),k===null){let G="webgl2";if(k=Ct(G,T),k===null)throw Ct(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Jt()}catch(T){throw e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",Kt,!1),e.removeEventListener("webglcontextcreationerror",At,!1),te("WebGLRenderer: "+T.message),T}function Jt(){$t=new zb(k),$t.init(),_t=new bw(k,$t),se=new Rb(k,$t,t,_t),St=new vw(k,$t),se.reversedDepthBuffer&&f&&St.buffers.depth.setReversed(!0),F=k.createFramebuffer(),I=k.createFramebuffer(),z=k.createFramebuffer(),Be=new Hb(k),Vt=new ow,qt=new Mw(k,$t,St,Vt,se,_t,Be),R=new kb(D),b=new Xy(k),bt=new Ab(k,b),Y=new Vb(k,b,Be,bt),ut=new Xb(k,Y,b,bt,Be),rt=new Wb(k,se,qt),st=new Pb(Vt),at=new rw(D,R,$t,se,bt,st),xt=new Tw(D,Vt),yt=new lw,et=new pw($t),O=new Tb(D,R,St,ut,g,l),mt=new yw(D,ut,se),Gt=new Aw(k,Be,se,St),nt=new Cb(k,$t,Be),wt=new Gb(k,$t,Be),Be.programs=at.programs,D.capabilities=se,D.extensions=$t,D.properties=Vt,D.renderLists=yt,D.shadowMap=mt,D.state=St,D.info=Be}x!==gi&&(U=new Yb(x,e.width,e.height,a,s,r));let ht=new Wf(D,k);this.xr=ht,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let T=$t.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=$t.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return gt},this.setPixelRatio=function(T){T!==void 0&&(gt=T,this.setSize(dt,Mt,!1))},this.getSize=function(T){return T.set(dt,Mt)},this.setSize=function(T,G,Q=!0){if(ht.isPresenting){Yt("WebGLRenderer: Can't change size while VR device is presenting.");return}dt=T,Mt=G,e.width=Math.floor(T*gt),e.height=Math.floor(G*gt),Q===!0&&(e.style.width=T+"px",e.style.height=G+"px"),U!==null&&U.setSize(e.width,e.height),this.setViewport(0,0,T,G)},this.getDrawingBufferSize=function(T){return T.set(dt*gt,Mt*gt).floor()},this.setDrawingBufferSize=function(T,G,Q){dt=T,Mt=G,gt=Q,e.width=Math.floor(T*Q),e.height=Math.floor(G*Q),this.setViewport(0,0,T,G)},this.setEffects=function(T){if(x===gi){te("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let G=0;G<T.length;G++)if(T[G].isOutputPass===!0){Yt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(tt)},this.getViewport=function(T){return T.copy(Nt)},this.setViewport=function(T,G,Q,$){T.isVector4?Nt.set(T.x,T.y,T.z,T.w):Nt.set(T,G,Q,$),St.viewport(tt.copy(Nt).multiplyScalar(cn()).round())},this.getScissor=function(T){return T.copy(ee)},this.setScissor=function(T,G,Q,$){T.isVector4?ee.set(T.x,T.y,T.z,T.w):ee.set(T,G,Q,$),St.scissor(lt.copy(ee).multiplyScalar(cn()).round())},this.getScissorTest=function(){return jt},this.setScissorTest=function(T){St.setScissorTest(jt=T)},this.setOpaqueSort=function(T){kt=T},this.setTransparentSort=function(T){Wt=T},this.getClearColor=function(T){return T.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(T=!0,G=!0,Q=!0){let $=0;if(T){let J=!1;if(ot!==null){let Et=ot.texture.format;J=m.has(Et)}if(J){let Et=ot.texture.type,Rt=p.has(Et),Tt=O.getClearColor(),Pt=O.getClearAlpha(),zt=Tt.r,Qt=Tt.g,ue=Tt.b;Rt?(v[0]=zt,v[1]=Qt,v[2]=ue,v[3]=Pt,k.clearBufferuiv(k.COLOR,0,v)):(A[0]=zt,A[1]=Qt,A[2]=ue,A[3]=Pt,k.clearBufferiv(k.COLOR,0,A))}else $|=k.COLOR_BUFFER_BIT}G&&($|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&($|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&k.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),B=T},this.dispose=function(){e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",Kt,!1),e.removeEventListener("webglcontextcreationerror",At,!1),O.dispose(),yt.dispose(),et.dispose(),qt.dispose(),Vt.dispose(),R.dispose(),ut.dispose(),Y.dispose(),bt.dispose(),Gt.dispose(),at.dispose(),ht.dispose(),ht.removeEventListener("sessionstart",Fa),ht.removeEventListener("sessionend",Bi),ts.stop()};function Ot(T){T.preventDefault(),Tf("WebGLRenderer: Context Lost."),L=!0}function Kt(){Tf("WebGLRenderer: Context Restored."),L=!1;let T=Be.autoReset,G=mt.enabled,Q=mt.autoUpdate,$=mt.needsUpdate,J=mt.type;Jt(),Be.autoReset=T,mt.enabled=G,mt.autoUpdate=Q,mt.needsUpdate=$,mt.type=J}function At(T){te("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function oe(T){let G=T.target;G.removeEventListener("dispose",oe),He(G)}function He(T){Bn(T),Vt.remove(T)}function Bn(T){let G=Vt.get(T).programs;G!==void 0&&(G.forEach(function(Q){at.releaseProgram(Q)}),T.isShaderMaterial&&at.releaseShaderCache(T))}this.renderBufferDirect=function(T,G,Q,$,J,Et){G===null&&(G=_n);let Rt=J.isMesh&&J.matrixWorld.determinantAffine()<0,Tt=Io(T,G,Q,$,J);St.setMaterial($,Rt);let Pt=Q.index,zt=1;if($.wireframe===!0){if(Pt=Y.getWireframeAttribute(Q),Pt===void 0)return;zt=2}let Qt=Q.drawRange,ue=Q.attributes.position,Bt=Qt.start*zt,fe=(Qt.start+Qt.count)*zt;Et!==null&&(Bt=Math.max(Bt,Et.start*zt),fe=Math.min(fe,(Et.start+Et.count)*zt)),Pt!==null?(Bt=Math.max(Bt,0),fe=Math.min(fe,Pt.count)):ue!=null&&(Bt=Math.max(Bt,0),fe=Math.min(fe,ue.count));let je=fe-Bt;if(je<0||je===1/0)return;bt.setup(J,$,Tt,Q,Pt);let Pe,Ie=nt;if(Pt!==null&&(Pe=b.get(Pt),Ie=wt,Ie.setIndex(Pe)),J.isMesh)$.wireframe===!0?(St.setLineWidth($.wireframeLinewidth*cn()),Ie.setMode(k.LINES)):Ie.setMode(k.TRIANGLES);else if(J.isLine){let xn=$.linewidth;xn===void 0&&(xn=1),St.setLineWidth(xn*cn()),J.isLineSegments?Ie.setMode(k.LINES):J.isLineLoop?Ie.setMode(k.LINE_LOOP):Ie.setMode(k.LINE_STRIP)}else J.isPoints?Ie.setMode(k.POINTS):J.isSprite&&Ie.setMode(k.TRIANGLES);if(J.isBatchedMesh)if($t.get("WEBGL_multi_draw"))Ie.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let xn=J._multiDrawStarts,Ut=J._multiDrawCounts,hn=J._multiDrawCount,_e=Pt?b.get(Pt).bytesPerElement:1,ns=Vt.get($).currentProgram.getUniforms();for(let un=0;un<hn;un++)ns.setValue(k,"_gl_DrawID",un),Ie.render(xn[un]/_e,Ut[un])}else if(J.isInstancedMesh)Ie.renderInstances(Bt,je,J.count);else if(Q.isInstancedBufferGeometry){let xn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Ut=Math.min(Q.instanceCount,xn);Ie.renderInstances(Bt,je,Ut)}else Ie.render(Bt,je)};function Co(T,G,Q,$){B!==null&&T.isNodeMaterial&&B.setObject($,T),ae===!0&&st.setState(T,Q,!1),T.transparent===!0&&T.side===Dn&&T.forceSinglePass===!1?(T.side=Zn,T.needsUpdate=!0,ki(T,G,$),T.side=$s,T.needsUpdate=!0,ki(T,G,$),T.side=Dn):ki(T,G,$)}this.compile=function(T,G,Q=null){Q===null&&(Q=T),B!==null&&B.renderStart(T,G,Q),S=et.get(Q),S.init(G),E.push(S),Q.traverseVisible(function(J){J.isLight&&J.layers.test(G.layers)&&(S.pushLight(J),J.castShadow&&S.pushShadow(J))}),T!==Q&&T.traverseVisible(function(J){J.isLight&&J.layers.test(G.layers)&&(S.pushLight(J),J.castShadow&&S.pushShadow(J))}),S.setupLights(),B!==null&&B.updateLights(S.state.lightsArray),Ue=this.localClippingEnabled,ae=st.init(this.clippingPlanes,Ue),ae===!0&&st.setGlobalState(this.clippingPlanes,G),B!==null&&mt.render(S.state.shadowsArray,Q,G);let $=new Set;return T.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Et=J.material;if(Et)if(Array.isArray(Et))for(let Rt=0;Rt<Et.length;Rt++){let Tt=Et[Rt];Co(Tt,Q,G,J),$.add(Tt)}else Co(Et,Q,G,J),$.add(Et)}),S=E.pop(),B!==null&&B.renderEnd(),$},this.compileAsync=function(T,G,Q=null){let $=this.compile(T,G,Q);return new Promise(J=>{function Et(){if($.forEach(function(Rt){let Pt=Vt.get(Rt).currentProgram;(Pt===void 0||Pt.isReady())&&$.delete(Rt)}),$.size===0){J(T);return}setTimeout(Et,10)}$t.get("KHR_parallel_shader_compile")!==null?Et():setTimeout(Et,10)})};let Sr=null;function Eh(T){Sr&&Sr(T)}function Fa(){ts.stop()}function Bi(){ts.start()}let ts=new Qg;ts.setAnimationLoop(Eh),typeof self<"u"&&ts.setContext(self),this.setAnimationLoop=function(T){Sr=T,ht.setAnimationLoop(T),T===null?ts.stop():ts.start()},ht.addEventListener("sessionstart",Fa),ht.addEventListener("sessionend",Bi),this.render=function(T,G){if(G!==void 0&&G.isCamera!==!0){te("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;B!==null&&B.renderStart(T,G);let Q=ht.enabled===!0&&ht.isPresenting===!0,$=U!==null&&(ot===null||Q)&&U.begin(D,ot);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),ht.enabled===!0&&ht.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ht.cameraAutoUpdate===!0&&ht.updateCamera(G),G=ht.getCamera()),T.isScene===!0&&T.onBeforeRender(D,T,G,ot),S=et.get(T,E.length),S.init(G),S.state.textureUnits=qt.getTextureUnits(),E.push(S),ge.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?Ne.setFromArrayCamera(G):Xt.setFromProjectionMatrix(ge,Si,G.reversedDepth),Ue=this.localClippingEnabled,ae=st.init(this.clippingPlanes,Ue),C=yt.get(T,_.length),C.init(),_.push(C),this.info.render.frame++,ht.enabled===!0&&ht.isPresenting===!0){let Rt=D.xr.getDepthSensingMesh();Rt!==null&&es(Rt,G,-1/0,D.sortObjects)}es(T,G,0,D.sortObjects),C.finish(),B!==null&&B.updateLights(S.state.lightsArray),D.sortObjects===!0&&C.sort(kt,Wt),en=ht.enabled===!1||ht.isPresenting===!1||ht.hasDepthSensing()===!1,en&&O.addToRenderList(C,T),this.info.autoReset===!0&&this.info.reset(),ae===!0&&st.beginShadows();let J=S.state.shadowsArray;if(mt.render(J,T,G),ae===!0&&st.endShadows(),($&&U.hasRenderPass())===!1){let Rt=C.opaque,Tt=C.transmissive;if(S.setupLights(),G.isArrayCamera){let Pt=G.cameras;if(Tt.length>0)for(let zt=0,Qt=Pt.length;zt<Qt;zt++){let ue=Pt[zt];wi(Rt,Tt,T,ue)}en&&O.render(T);for(let zt=0,Qt=Pt.length;zt<Qt;zt++){let ue=Pt[zt];Ro(C,T,ue,ue.viewport)}}else Tt.length>0&&wi(Rt,Tt,T,G),en&&O.render(T),Ro(C,T,G)}ot!==null&&V===0&&(qt.updateMultisampleRenderTarget(ot),qt.updateRenderTargetMipmap(ot)),$&&U.end(D),T.isScene===!0&&T.onAfterRender(D,T,G),bt.resetDefaultState(),q=-1,j=null,E.pop(),E.length>0?(S=E[E.length-1],qt.setTextureUnits(S.state.textureUnits),ae===!0&&st.setGlobalState(D.clippingPlanes,S.state.camera)):S=null,_.pop(),_.length>0?C=_[_.length-1]:C=null,B!==null&&B.renderEnd()};function es(T,G,Q,$){if(T.visible===!1)return;if(T.layers.test(G.layers)){if(T.isGroup)Q=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(G);else if(T.isLight)S.pushLight(T),T.castShadow&&S.pushShadow(T);else if(T.isSprite){let Rt=G.isArrayCamera?Ne:Xt;if(!T.frustumCulled||T.intersectsFrustum(Rt)){$&&be.setFromMatrixPosition(T.matrixWorld).applyMatrix4(ge);let Tt=ut.update(T),Pt=T.material;Pt.visible&&C.push(T,Tt,Pt,Q,be.z,null,G)}}else if(T.isMesh||T.isLine||T.isPoints){let Rt=G.isArrayCamera?Ne:Xt;if(!T.frustumCulled||T.intersectsFrustum(Rt)){let Tt=ut.update(T),Pt=T.material;if($&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),be.copy(T.boundingSphere.center)):(Tt.boundingSphere===null&&Tt.computeBoundingSphere(),be.copy(Tt.boundingSphere.center)),be.applyMatrix4(T.matrixWorld).applyMatrix4(ge)),Array.isArray(Pt)){let zt=Tt.groups;for(let Qt=0,ue=zt.length;Qt<ue;Qt++){let Bt=zt[Qt],fe=Pt[Bt.materialIndex];fe&&fe.visible&&C.push(T,Tt,fe,Q,be.z,Bt,G)}}else Pt.visible&&C.push(T,Tt,Pt,Q,be.z,null,G)}}}let Et=T.children;for(let Rt=0,Tt=Et.length;Rt<Tt;Rt++)es(Et[Rt],G,Q,$)}function Ro(T,G,Q,$){let{opaque:J,transmissive:Et,transparent:Rt}=T;S.setupLightsView(Q),ae===!0&&st.setGlobalState(D.clippingPlanes,Q),$&&St.viewport(tt.copy($)),J.length>0&&nn(J,G,Q),Et.length>0&&nn(Et,G,Q),Rt.length>0&&nn(Rt,G,Q),St.buffers.depth.setTest(!0),St.buffers.depth.setMask(!0),St.buffers.color.setMask(!0),St.setPolygonOffset(!1)}function wi(T,G,Q,$){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(S.state.transmissionRenderTarget[$.id]===void 0){let Bt=$t.has("EXT_color_buffer_half_float")||$t.has("EXT_color_buffer_float");S.state.transmissionRenderTarget[$.id]=new pi(1,1,{generateMipmaps:!0,type:Bt?Ui:gi,minFilter:Ms,samples:Math.max(4,se.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ye.workingColorSpace})}let Et=S.state.transmissionRenderTarget[$.id],Rt=$.viewport||tt;Et.setSize(Rt.z*D.transmissionResolutionScale,Rt.w*D.transmissionResolutionScale);let Tt=D.getRenderTarget(),Pt=D.getActiveCubeFace(),zt=D.getActiveMipmapLevel();D.setRenderTarget(Et),D.getClearColor(Z),ft=D.getClearAlpha(),ft<1&&D.setClearColor(16777215,.5),D.clear(),en&&O.render(Q);let Qt=D.toneMapping;D.toneMapping=Ki;let ue=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),S.setupLightsView($),ae===!0&&st.setGlobalState(D.clippingPlanes,$),nn(T,Q,$),qt.updateMultisampleRenderTarget(Et),qt.updateRenderTargetMipmap(Et),$t.has("WEBGL_multisampled_render_to_texture")===!1){let Bt=!1;for(let fe=0,je=G.length;fe<je;fe++){let Pe=G[fe],{object:Ie,geometry:xn,material:Ut,group:hn}=Pe;if(Ut.side===Dn&&Ie.layers.test($.layers)){let _e=Ut.side;Ut.side=Zn,Ut.needsUpdate=!0,an(Ie,Q,$,xn,Ut,hn),Ut.side=_e,Ut.needsUpdate=!0,Bt=!0}}Bt===!0&&(qt.updateMultisampleRenderTarget(Et),qt.updateRenderTargetMipmap(Et))}D.setRenderTarget(Tt,Pt,zt),D.setClearColor(Z,ft),ue!==void 0&&($.viewport=ue),D.toneMapping=Qt}function nn(T,G,Q){let $=G.isScene===!0?G.overrideMaterial:null;for(let J=0,Et=T.length;J<Et;J++){let Rt=T[J],{object:Tt,geometry:Pt,group:zt}=Rt,Qt=Rt.material;Qt.allowOverride===!0&&$!==null&&(Qt=$),Tt.layers.test(Q.layers)&&an(Tt,G,Q,Pt,Qt,zt)}}function an(T,G,Q,$,J,Et){B!==null&&J.isNodeMaterial&&B.setObject(T,J),T.onBeforeRender(D,G,Q,$,J,Et),T.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),J.onBeforeRender(D,G,Q,$,T,Et),J.transparent===!0&&J.side===Dn&&J.forceSinglePass===!1?(J.side=Zn,J.needsUpdate=!0,D.renderBufferDirect(Q,G,$,J,T,Et),J.side=$s,J.needsUpdate=!0,D.renderBufferDirect(Q,G,$,J,T,Et),J.side=Dn):D.renderBufferDirect(Q,G,$,J,T,Et),T.onAfterRender(D,G,Q,$,J,Et)}function ln(T){let G=0;for(let Q of T)Q.texture!==null&&G++;return G}function ki(T,G,Q){G.isScene!==!0&&(G=_n);let $=Vt.get(T),J=S.state.lights,Et=S.state.shadowsArray,Rt=J.state.version,Tt=at.getParameters(T,J.state,Et,G,Q,S.state.lightProbeGridArray),Pt=at.getProgramCacheKey(Tt),zt=$.programs;$.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?G.environment:null,$.fog=G.fog;let Qt=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;$.envMap=R.get(T.envMap||$.environment,Qt),$.envMapRotation=$.environment!==null&&T.envMap===null?G.environmentRotation:T.envMapRotation,zt===void 0&&(T.addEventListener("dispose",oe),zt=new Map,$.programs=zt,$.programVariants=new Map);let ue=zt.get(Pt);if(ue!==void 0){if($.currentProgram===ue&&$.lightsStateVersion===Rt)return Po(T,Tt),ue}else Tt.uniforms=at.getUniforms(T),B!==null&&T.isNodeMaterial&&B.build(T,Q,Tt),T.onBeforeCompile(Tt,D),ue=at.acquireProgram(Tt,Pt),zt.set(Pt,ue),$.uniforms=Tt.uniforms;let Bt=$.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Bt.clippingPlanes=st.uniform),Po(T,Tt),$.needsLights=Ts(T),$.lightsStateVersion=Rt,$.needsLights&&(Bt.ambientLightColor.value=J.state.ambient,Bt.lightProbe.value=J.state.probe,Bt.sunLights.value=J.state.sun,Bt.sunLightShadows.value=J.state.sunShadow,Bt.directionalLights.value=J.state.directional,Bt.directionalLightShadows.value=J.state.directionalShadow,Bt.spotLights.value=J.state.spot,Bt.spotLightShadows.value=J.state.spotShadow,Bt.rectAreaLights.value=J.state.rectArea,Bt.ltc_1.value=J.state.rectAreaLTC1,Bt.ltc_2.value=J.state.rectAreaLTC2,Bt.pointLights.value=J.state.point,Bt.pointLightShadows.value=J.state.pointShadow,Bt.hemisphereLights.value=J.state.hemi,Bt.sunShadowMatrix.value=J.state.sunShadowMatrix,Bt.sunShadowCascade.value=J.state.sunShadowCascade,Bt.directionalShadowMatrix.value=J.state.directionalShadowMatrix,Bt.spotLightMatrix.value=J.state.spotLightMatrix,Bt.spotLightMap.value=J.state.spotLightMap,Bt.pointShadowMatrix.value=J.state.pointShadowMatrix),$.numLightProbeGrids=ln(S.state.lightProbeGridArray),$.currentProgram=ue,$.uniformsList=null,ue}function ii(T,G,Q,$,J){let Et=Vt.get(T),Rt=Et.currentProgram.id+","+$+","+J,Tt=Et.programVariants.get(Rt);return Tt===void 0?(Tt=ki(T,G,Q),Et.programVariants.set(Rt,Tt)):(Et.currentProgram=Tt,Et.uniformsList=null,Et.outputColorSpace=$,Et.toneMapping=J),Tt}function Es(T){if(T.uniformsList===null){let G=T.currentProgram.getUniforms();T.uniformsList=Mo.seqWithValue(G.seq,T.uniforms)}return T.uniformsList}function Po(T,G){let Q=Vt.get(T);Q.outputColorSpace=G.outputColorSpace,Q.batching=G.batching,Q.batchingColor=G.batchingColor,Q.instancing=G.instancing,Q.instancingColor=G.instancingColor,Q.instancingMorph=G.instancingMorph,Q.skinning=G.skinning,Q.morphTargets=G.morphTargets,Q.morphNormals=G.morphNormals,Q.morphColors=G.morphColors,Q.morphTargetsCount=G.morphTargetsCount,Q.numClippingPlanes=G.numClippingPlanes,Q.numIntersection=G.numClipIntersection,Q.vertexAlphas=G.vertexAlphas,Q.vertexTangents=G.vertexTangents,Q.toneMapping=G.toneMapping}function Io(T,G,Q,$,J){G.isScene!==!0&&(G=_n),qt.resetTextureUnits();let Et=G.fog,Rt=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?G.environment:null,Tt=ot===null?D.outputColorSpace:ot.isXRRenderTarget===!0?ot.texture.colorSpace:ye.workingColorSpace,Pt=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,zt=R.get($.envMap||Rt,Pt),Qt=$.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,ue=!!Q.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Bt=!!Q.morphAttributes.position,fe=!!Q.morphAttributes.normal,je=!!Q.morphAttributes.color,Pe=Ki;$.toneMapped&&(ot===null||ot.isXRRenderTarget===!0)&&(Pe=D.toneMapping);let Ie=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,xn=Ie!==void 0?Ie.length:0,Ut=Vt.get($),hn=S.state.lights;if(ae===!0&&(Ue===!0||T!==j)){let Le=T===j&&$.id===q;st.setState($,T,Le)}let _e=!1,ns=!1;$.version===Ut.__version?Ut.needsLights&&Ut.lightsStateVersion!==hn.state.version||J.isBatchedMesh&&Ut.batching===!1||!J.isBatchedMesh&&Ut.batching===!0||J.isBatchedMesh&&Ut.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&Ut.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&Ut.instancing===!1||!J.isInstancedMesh&&Ut.instancing===!0||J.isSkinnedMesh&&Ut.skinning===!1||!J.isSkinnedMesh&&Ut.skinning===!0||J.isInstancedMesh&&Ut.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Ut.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Ut.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Ut.instancingMorph===!1&&J.morphTexture!==null||Ut.envMap!==zt||$.fog===!0&&Ut.fog!==Et||Ut.numClippingPlanes!==void 0&&(Ut.numClippingPlanes!==st.numPlanes||Ut.numIntersection!==st.numIntersection)||Ut.vertexAlphas!==Qt||Ut.vertexTangents!==ue||Ut.morphTargets!==Bt||Ut.morphNormals!==fe||Ut.morphColors!==je||Ut.morphTargetsCount!==xn||Ut.numLightProbeGrids!==ln(S.state.lightProbeGridArray)?_e=!0:(Ut.outputColorSpace!==Tt||Ut.toneMapping!==Pe)&&(ns=!0):(_e=!0,Ut.__version=$.version);let un=Ut.currentProgram;(_e===!0||ns===!0)&&(un=ns===!0?ii($,G,J,Tt,Pe):ki($,G,J),B&&$.isNodeMaterial&&B.onUpdateProgram($,un,Ut));let Tr=!1,zi=!1,is=!1,le=un.getUniforms(),sn=Ut.uniforms;if(St.useProgram(un.program)&&(Tr=!0,zi=!0,is=!0),$.id!==q&&(q=$.id,zi=!0),Tr||j!==T){St.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),le.setValue(k,"projectionMatrix",T.projectionMatrix),le.setValue(k,"viewMatrix",T.matrixWorldInverse);let fn=le.map.cameraPosition;fn!==void 0&&fn.setValue(k,Ke.setFromMatrixPosition(T.matrixWorld)),se.logarithmicDepthBuffer&&le.setValue(k,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&le.setValue(k,"isOrthographic",T.isOrthographicCamera===!0),j!==T&&(j=T,zi=!0,is=!0)}if(Ut.needsLights&&(hn.state.sunShadowMap.length>0&&le.setValue(k,"sunShadowMap",hn.state.sunShadowMap,qt),hn.state.directionalShadowMap.length>0&&le.setValue(k,"directionalShadowMap",hn.state.directionalShadowMap,qt),hn.state.spotShadowMap.length>0&&le.setValue(k,"spotShadowMap",hn.state.spotShadowMap,qt),hn.state.pointShadowMap.length>0&&le.setValue(k,"pointShadowMap",hn.state.pointShadowMap,qt)),J.isSkinnedMesh){le.setOptional(k,J,"bindMatrix"),le.setOptional(k,J,"bindMatrixInverse");let Le=J.skeleton;Le&&(Le.boneTexture===null&&Le.computeBoneTexture(),le.setValue(k,"boneTexture",Le.boneTexture,qt))}J.isBatchedMesh&&(le.setOptional(k,J,"batchingTexture"),le.setValue(k,"batchingTexture",J._matricesTexture,qt),le.setOptional(k,J,"batchingIdTexture"),le.setValue(k,"batchingIdTexture",J._indirectTexture,qt),le.setOptional(k,J,"batchingColorTexture"),J._colorsTexture!==null&&le.setValue(k,"batchingColorTexture",J._colorsTexture,qt));let kn=Q.morphAttributes;if((kn.position!==void 0||kn.normal!==void 0||kn.color!==void 0)&&rt.update(J,Q,un),(zi||Ut.receiveShadow!==J.receiveShadow)&&(Ut.receiveShadow=J.receiveShadow,le.setValue(k,"receiveShadow",J.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&G.environment!==null&&(sn.envMapIntensity.value=G.environmentIntensity),sn.dfgLUT!==void 0&&(sn.dfgLUT.value=Rw()),zi){if(le.setValue(k,"toneMappingExposure",D.toneMappingExposure),Ut.needsLights&&wr(sn,is),Et&&$.fog===!0&&xt.refreshFogUniforms(sn,Et),xt.refreshMaterialUniforms(sn,$,gt,Mt,S.state.transmissionRenderTarget[T.id]),Ut.needsLights&&Ut.numLightProbeGrids>0){let Le=M,fn=0;for(let Nn of S.state.lightProbeGridArray)Nn.texture!==null&&(Le.textures[fn]=Nn.texture,Le.min[fn]=Nn.boundingBox.min,Le.max[fn]=Nn.boundingBox.max,Le.resolution[fn]=Nn.resolution,fn++);for(let Nn in Le)Le[Nn].length=fn;sn.probesSH.value=Le.textures,sn.probesMin.value=Le.min,sn.probesMax.value=Le.max,sn.probesResolution.value=Le.resolution}Mo.upload(k,Es(Ut),sn,qt)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(Mo.upload(k,Es(Ut),sn,qt),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&le.setValue(k,"center",J.center),le.setValue(k,"modelViewMatrix",J.modelViewMatrix),le.setValue(k,"normalMatrix",J.normalMatrix),le.setValue(k,"modelMatrix",J.matrixWorld),$.uniformsGroups!==void 0){let Le=$.uniformsGroups;for(let fn=0,Nn=Le.length;fn<Nn;fn++){let Oa=Le[fn];Gt.update(Oa,un),Gt.bind(Oa,un)}}return un}function wr(T,G){T.ambientLightColor.needsUpdate=G,T.lightProbe.needsUpdate=G,T.sunLights.needsUpdate=G,T.sunLightShadows.needsUpdate=G,T.directionalLights.needsUpdate=G,T.directionalLightShadows.needsUpdate=G,T.pointLights.needsUpdate=G,T.pointLightShadows.needsUpdate=G,T.spotLights.needsUpdate=G,T.spotLightShadows.needsUpdate=G,T.rectAreaLights.needsUpdate=G,T.hemisphereLights.needsUpdate=G}function Ts(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return X},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return ot},this.setRenderTargetTextures=function(T,G,Q){let $=Vt.get(T);$.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Vt.get(T.texture).__webglTexture=G,Vt.get(T.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:Q,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,G){let Q=Vt.get(T);Q.__webglFramebuffer=G,Q.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(T,G=0,Q=0){ot=T,X=G,V=Q;let $=null,J=!1,Et=!1;if(T){let Tt=Vt.get(T);if(Tt.__useDefaultFramebuffer!==void 0){St.bindFramebuffer(k.FRAMEBUFFER,Tt.__webglFramebuffer),tt.copy(T.viewport),lt.copy(T.scissor),it=T.scissorTest,St.viewport(tt),St.scissor(lt),St.setScissorTest(it),q=-1;return}else if(Tt.__webglFramebuffer===void 0)qt.setupRenderTarget(T);else if(Tt.__hasExternalTextures)qt.rebindTextures(T,Vt.get(T.texture).__webglTexture,Vt.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let Qt=T.depthTexture;if(Tt.__boundDepthTexture!==Qt){if(Qt!==null&&Vt.has(Qt)&&(T.width!==Qt.image.width||T.height!==Qt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qt.setupDepthRenderbuffer(T)}}let Pt=T.texture;(Pt.isData3DTexture||Pt.isDataArrayTexture||Pt.isCompressedArrayTexture)&&(Et=!0);let zt=Vt.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(zt[G])?$=zt[G][Q]:$=zt[G],J=!0):T.samples>0&&qt.useMultisampledRTT(T)===!1?$=Vt.get(T).__webglMultisampledFramebuffer:Array.isArray(zt)?$=zt[Q]:$=zt,tt.copy(T.viewport),lt.copy(T.scissor),it=T.scissorTest}else tt.copy(Nt).multiplyScalar(gt).floor(),lt.copy(ee).multiplyScalar(gt).floor(),it=jt;if(Q!==0&&($=F),St.bindFramebuffer(k.FRAMEBUFFER,$)&&St.drawBuffers(T,$),St.viewport(tt),St.scissor(lt),St.setScissorTest(it),J){let Tt=Vt.get(T.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+G,Tt.__webglTexture,Q)}else if(Et){let Tt=G;for(let Pt=0;Pt<T.textures.length;Pt++){let zt=Vt.get(T.textures[Pt]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Pt,zt.__webglTexture,Q,Tt)}}else if(T!==null&&Q!==0){let Tt=Vt.get(T.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Tt.__webglTexture,Q)}q=-1};function Er(T){let G=Vt.get(T);return(G.__readFormat!==T.format||G.__readType!==T.type)&&(G.__readFormat=T.format,G.__readType=T.type,G.__formatReadable=se.textureFormatReadable(T.format),G.__typeReadable=se.textureTypeReadable(T.type)),G}this.readRenderTargetPixels=function(T,G,Q,$,J,Et,Rt,Tt=0){if(!(T&&T.isWebGLRenderTarget)){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Pt=Vt.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Rt!==void 0&&(Pt=Pt[Rt],Array.isArray(Pt)&&(Pt=Pt[0])),Pt){St.bindFramebuffer(k.FRAMEBUFFER,Pt);try{let zt=T.textures[Tt],Qt=zt.format,ue=zt.type;T.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Tt);let Bt=Er(zt);if(Bt.__formatReadable===!1){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Bt.__typeReadable===!1){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=T.width-$&&Q>=0&&Q<=T.height-J&&k.readPixels(G,Q,$,J,_t.convert(Qt),_t.convert(ue),Et)}finally{let zt=ot!==null?Vt.get(ot).__webglFramebuffer:null;St.bindFramebuffer(k.FRAMEBUFFER,zt)}}},this.readRenderTargetPixelsAsync=async function(T,G,Q,$,J,Et,Rt,Tt=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Pt=Vt.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Rt!==void 0&&(Pt=Pt[Rt],Array.isArray(Pt)&&(Pt=Pt[0])),Pt)if(G>=0&&G<=T.width-$&&Q>=0&&Q<=T.height-J){St.bindFramebuffer(k.FRAMEBUFFER,Pt);let zt=T.textures[Tt],Qt=zt.format,ue=zt.type;T.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Tt);let Bt=Er(zt);if(Bt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Bt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let fe=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,fe),k.bufferData(k.PIXEL_PACK_BUFFER,Et.byteLength,k.STREAM_READ),k.readPixels(G,Q,$,J,_t.convert(Qt),_t.convert(ue),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let je=ot!==null?Vt.get(ot).__webglFramebuffer:null;St.bindFramebuffer(k.FRAMEBUFFER,je);let Pe=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await wg(k,Pe,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,fe),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Et),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(fe),k.deleteSync(Pe),Et}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,G=null,Q=0){let $=Math.pow(2,-Q),J=Math.floor(T.image.width*$),Et=Math.floor(T.image.height*$),Rt=G!==null?G.x:0,Tt=G!==null?G.y:0;qt.setTexture2D(T,0),k.copyTexSubImage2D(k.TEXTURE_2D,Q,0,0,Rt,Tt,J,Et),St.unbindTexture()},this.copyTextureToTexture=function(T,G,Q=null,$=null,J=0,Et=0){let Rt,Tt,Pt,zt,Qt,ue,Bt,fe,je,Pe=T.isCompressedTexture?T.mipmaps[Et]:T.image;if(Q!==null)Rt=Q.max.x-Q.min.x,Tt=Q.max.y-Q.min.y,Pt=Q.isBox3?Q.max.z-Q.min.z:1,zt=Q.min.x,Qt=Q.min.y,ue=Q.isBox3?Q.min.z:0;else{let le=Math.pow(2,-J);Rt=Math.floor(Pe.width*le),Tt=Math.floor(Pe.height*le),T.isDataArrayTexture?Pt=Pe.depth:T.isData3DTexture?Pt=Math.floor(Pe.depth*le):Pt=1,zt=0,Qt=0,ue=0}$!==null?(Bt=$.x,fe=$.y,je=$.z):(Bt=0,fe=0,je=0);let Ie=_t.convert(G.format),xn=_t.convert(G.type),Ut;G.isData3DTexture?(qt.setTexture3D(G,0),Ut=k.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(qt.setTexture2DArray(G,0),Ut=k.TEXTURE_2D_ARRAY):(qt.setTexture2D(G,0),Ut=k.TEXTURE_2D),St.activeTexture(k.TEXTURE0),St.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,G.flipY),St.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),St.pixelStorei(k.UNPACK_ALIGNMENT,G.unpackAlignment);let hn=St.getParameter(k.UNPACK_ROW_LENGTH),_e=St.getParameter(k.UNPACK_IMAGE_HEIGHT),ns=St.getParameter(k.UNPACK_SKIP_PIXELS),un=St.getParameter(k.UNPACK_SKIP_ROWS),Tr=St.getParameter(k.UNPACK_SKIP_IMAGES);St.pixelStorei(k.UNPACK_ROW_LENGTH,Pe.width),St.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Pe.height),St.pixelStorei(k.UNPACK_SKIP_PIXELS,zt),St.pixelStorei(k.UNPACK_SKIP_ROWS,Qt),St.pixelStorei(k.UNPACK_SKIP_IMAGES,ue);let zi=T.isDataArrayTexture||T.isData3DTexture,is=G.isDataArrayTexture||G.isData3DTexture;if(T.isDepthTexture){let le=Vt.get(T),sn=Vt.get(G),kn=Vt.get(le.__renderTarget),Le=Vt.get(sn.__renderTarget);St.bindFramebuffer(k.READ_FRAMEBUFFER,kn.__webglFramebuffer),St.bindFramebuffer(k.DRAW_FRAMEBUFFER,Le.__webglFramebuffer);for(let fn=0;fn<Pt;fn++)zi&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Vt.get(T).__webglTexture,J,ue+fn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Vt.get(G).__webglTexture,Et,je+fn)),k.blitFramebuffer(zt,Qt,zt+Rt,Qt+Tt,Bt,fe,Bt+Rt,fe+Tt,k.DEPTH_BUFFER_BIT,k.NEAREST);St.bindFramebuffer(k.READ_FRAMEBUFFER,null),St.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(J!==0||T.isRenderTargetTexture||Vt.has(T)){let le=Vt.get(T),sn=Vt.get(G);St.bindFramebuffer(k.READ_FRAMEBUFFER,I),St.bindFramebuffer(k.DRAW_FRAMEBUFFER,z);for(let kn=0;kn<Pt;kn++)zi?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,le.__webglTexture,J,ue+kn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,le.__webglTexture,J),is?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,sn.__webglTexture,Et,je+kn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,sn.__webglTexture,Et),J!==0?k.blitFramebuffer(zt,Qt,zt+Rt,Qt+Tt,Bt,fe,Bt+Rt,fe+Tt,k.COLOR_BUFFER_BIT,k.NEAREST):is?k.copyTexSubImage3D(Ut,Et,Bt,fe,je+kn,zt,Qt,Rt,Tt):k.copyTexSubImage2D(Ut,Et,Bt,fe,zt,Qt,Rt,Tt);St.bindFramebuffer(k.READ_FRAMEBUFFER,null),St.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else is?T.isDataTexture||T.isData3DTexture?k.texSubImage3D(Ut,Et,Bt,fe,je,Rt,Tt,Pt,Ie,xn,Pe.data):G.isCompressedArrayTexture?k.compressedTexSubImage3D(Ut,Et,Bt,fe,je,Rt,Tt,Pt,Ie,Pe.data):k.texSubImage3D(Ut,Et,Bt,fe,je,Rt,Tt,Pt,Ie,xn,Pe):T.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Et,Bt,fe,Rt,Tt,Ie,xn,Pe.data):T.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Et,Bt,fe,Pe.width,Pe.height,Ie,Pe.data):k.texSubImage2D(k.TEXTURE_2D,Et,Bt,fe,Rt,Tt,Ie,xn,Pe);St.pixelStorei(k.UNPACK_ROW_LENGTH,hn),St.pixelStorei(k.UNPACK_IMAGE_HEIGHT,_e),St.pixelStorei(k.UNPACK_SKIP_PIXELS,ns),St.pixelStorei(k.UNPACK_SKIP_ROWS,un),St.pixelStorei(k.UNPACK_SKIP_IMAGES,Tr),Et===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&k.generateMipmap(Ut),St.unbindTexture()},this.initRenderTarget=function(T){Vt.get(T).__webglFramebuffer===void 0&&qt.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?qt.setTextureCube(T,0):T.isData3DTexture?qt.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?qt.setTexture2DArray(T,0):qt.setTexture2D(T,0),St.unbindTexture()},this.resetState=function(){X=0,V=0,ot=null,St.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Si}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=ye._getDrawingBufferColorSpace(t),e.unpackColorSpace=ye._getUnpackColorSpace()}};var Ia=`
uniform vec3 uStops[5];
uniform float uShares[5];
vec3 colourOf(float share) {
  vec3 c = uStops[0];
  for (int k = 1; k < 5; ++k) c = mix(c, uStops[k], clamp((share - uShares[k - 1]) / (uShares[k] - uShares[k - 1]), 0.0, 1.0));
  return c;
}`;var La=`
uniform vec3 uLow, uSize;  // of the box [m]
uniform float uMix;        // 0: at frame a, 1: at frame b
vec3 placed(vec4 a, vec4 b) { return uLow + uSize * (65535.0 / 65534.0) * mix(a.xyz, b.xyz, uMix); }`,So=`
float lightOn(vec3 n) { return 0.42 + 0.58 * max(0.0, dot(n, vec3(-0.33, 0.62, 0.71))); }`,wo=(i,t,e)=>.42+.58*Math.max(0,-.33*i+.62*t+.71*e),Da=`
uniform vec4 uClip;  // normal, distance
bool clipped(vec3 x) { return dot(x, uClip.xyz) > uClip.w; }`;function lh(i){return{uStops:{value:i.stops.flatMap(t=>t.map(e=>e/255))},uShares:{value:i.shares}}}function ch(i){return{uLow:{value:i.low},uSize:{value:i.size},uMix:{value:0}}}var Pw=[.55,.6,.66],Iw=14274484,hh=class{constructor(t){this.run=t,this.object=new Qe,this.box=new Qn,t.bed&&this.box.union(new Qn(new W(...t.bed.low),new W(...t.bed.high)))}async load(){for(let t=0;t<(this.run.meshes??[]).length;++t){let e=Hn.has(`mesh-${t}`)?Hn.get(`mesh-${t}`):Jn(await os(`mesh-${t}`),Float32Array);this.corners=[...this.corners??[],e];for(let n=0;n<e.length;n+=3)this.box.expandByPoint(new W(e[n],e[n+1],e[n+2]))}}build(){for(let t of this.corners??[])this.object.add(this.mesh(t));return this.run.bed&&this.object.add(this.bed(this.run.bed)),this.object}mesh(t){let e=new Float32Array(t.length),n=a=>[t[a],t[a+1],t[a+2]];for(let a=0;a<t.length;a+=9){let[l,c,h]=[n(a),n(a+3),n(a+6)],u=c.map((p,v)=>p-l[v]),f=h.map((p,v)=>p-l[v]),d=[u[1]*f[2]-u[2]*f[1],u[2]*f[0]-u[0]*f[2],u[0]*f[1]-u[1]*f[0]],g=Math.hypot(...d)||1,x=d[2]<0?-1:1,m=wo(...d.map(p=>x*p/g));for(let p=0;p<9;++p)e[a+p]=Pw[p%3]*(.4+.6*m)}let s=new Oe;s.setAttribute("position",new Ve(t,3)),s.setAttribute("color",new Ve(e,3));let r=new Qe,o=new tn(s,new Zi({vertexColors:!0,side:Dn,transparent:!0,opacity:.28,depthWrite:!1}));return o.renderOrder=3,r.add(o,new ys(new uo(s,25),new Ji({color:6253432}))),r}bed({low:t,high:e}){let n=e.map((a,l)=>a-t[l]),s=new Gs(...n),r=new Qe,o=new tn(s,new Zi({color:Iw,transparent:!0,opacity:.55,depthWrite:!1}));return o.renderOrder=3,r.add(o,new ys(new uo(s),new Ji({color:9274472}))),r.position.set(...t.map((a,l)=>a+n[l]/2)),r}};var h0={type:"change"},qf={type:"start"},f0={type:"end"},uh=new Vs,u0=new di,Lw=Math.cos(70*Pf.DEG2RAD),Sn=new W,ti=2*Math.PI,Ae={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Xf=1e-6,fh=class extends xa{constructor(t,e=null){super(t,e),this.state=Ae.NONE,this.target=new W,this.cursor=new W,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:qs.ROTATE,MIDDLE:qs.DOLLY,RIGHT:qs.PAN},this.touches={ONE:Ys.ROTATE,TWO:Ys.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new W,this._lastQuaternion=new Yn,this._lastTargetPosition=new W,this._quat=new Yn().setFromUnitVectors(t.up,new W(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new po,this._sphericalDelta=new po,this._scale=1,this._panOffset=new W,this._rotateStart=new re,this._rotateEnd=new re,this._rotateDelta=new re,this._panStart=new re,this._panEnd=new re,this._panDelta=new re,this._dollyStart=new re,this._dollyEnd=new re,this._dollyDelta=new re,this._dollyDirection=new W,this._mouse=new re,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=Nw.bind(this),this._onPointerDown=Dw.bind(this),this._onPointerUp=Uw.bind(this),this._onContextMenu=Gw.bind(this),this._onMouseWheel=Bw.bind(this),this._onKeyDown=kw.bind(this),this._onTouchStart=zw.bind(this),this._onTouchMove=Vw.bind(this),this._onMouseDown=Fw.bind(this),this._onMouseMove=Ow.bind(this),this._interceptControlDown=Hw.bind(this),this._interceptControlUp=Ww.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ae.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(h0),this.update(),this.state=Ae.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Sn.copy(e).sub(this.target),Sn.applyQuaternion(this._quat),this._spherical.setFromVector3(Sn),this.autoRotate&&this.state===Ae.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=ti:n>Math.PI&&(n-=ti),s<-Math.PI?s+=ti:s>Math.PI&&(s-=ti),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Sn.setFromSpherical(this._spherical),Sn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Sn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Sn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new W(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new W(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Sn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(uh.origin.copy(this.object.position),uh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(uh.direction))<Lw?this.object.lookAt(this.target):(u0.setFromNormalAndCoplanarPoint(this.object.up,this.target),uh.intersectPlane(u0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Xf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Xf||this._lastTargetPosition.distanceToSquared(this.target)>Xf?(this.dispatchEvent(h0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ti/60*this.autoRotateSpeed*t:ti/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Sn.setFromMatrixColumn(e,0),Sn.multiplyScalar(-t),this._panOffset.add(Sn)}_panUp(t,e){this.screenSpacePanning===!0?Sn.setFromMatrixColumn(e,1):(Sn.setFromMatrixColumn(e,0),Sn.crossVectors(this.object.up,Sn)),Sn.multiplyScalar(t),this._panOffset.add(Sn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Sn.copy(s).sub(this.target);let r=Sn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ti*this._rotateDelta.x/e.clientHeight),this._rotateUp(ti*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ti*this._rotateDelta.x/e.clientHeight),this._rotateUp(ti*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new re,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function Dw(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function Nw(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function Uw(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(f0),this.state=Ae.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function Fw(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case qs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Ae.DOLLY;break;case qs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ae.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ae.ROTATE}break;case qs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ae.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ae.PAN}break;default:this.state=Ae.NONE}this.state!==Ae.NONE&&this.dispatchEvent(qf)}function Ow(i){switch(this.state){case Ae.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Ae.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Ae.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function Bw(i){this.enabled===!1||this.enableZoom===!1||this.state!==Ae.NONE||(i.preventDefault(),this.dispatchEvent(qf),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(f0))}function kw(i){this.enabled!==!1&&this._handleKeyDown(i)}function zw(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Ys.ROTATE:if(this.enableRotate===!1){this.state=Ae.NONE;break}this._handleTouchStartRotate(i),this.state=Ae.TOUCH_ROTATE;break;case Ys.PAN:if(this.enablePan===!1){this.state=Ae.NONE;break}this._handleTouchStartPan(i),this.state=Ae.TOUCH_PAN;break;default:this.state=Ae.NONE}break;case 2:switch(this.touches.TWO){case Ys.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Ae.TOUCH_DOLLY_PAN;break;case Ys.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Ae.TOUCH_DOLLY_ROTATE;break;default:this.state=Ae.NONE}break;default:this.state=Ae.NONE}this.state!==Ae.NONE&&this.dispatchEvent(qf)}function Vw(i){switch(this._trackPointer(i),this.state){case Ae.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Ae.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Ae.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Ae.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Ae.NONE}}function Gw(i){this.enabled!==!1&&i.preventDefault()}function Hw(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Ww(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Yf(i,t){let e=[],n=[];for(let[s,r]of t)for(let o=0;o<i;++o)e.push([r*Math.cos(2*Math.PI*o/i),r*Math.sin(2*Math.PI*o/i),s]);for(let s=0;s+1<t.length;++s)for(let r=0;r<i;++r){let o=s*i+r,a=s*i+(r+1)%i;t[s][1]>0&&n.push(o,a,o+i),t[s+1][1]>0&&n.push(a,a+i,o+i)}return{sides:i,rows:t,points:e,corners:n}}var $f={tube:Yf(8,[[0,0],[0,1],[1,1],[1,0]]),pipe:Yf(5,[[0,1],[1,1]]),ball:Yf(8,[0,1,2,3,4].map(i=>[(1-Math.cos(Math.PI*i/4))/2,i%4===0?0:Math.sin(Math.PI*i/4)]))},Zf=new Map;function Eo(i){return Zf.has(i)||Zf.set(i,[1,3,5].map(t=>parseInt(i.slice(t,t+2),16)/255)),Zf.get(i)}var ve=(i,t,e=1)=>[i[0]+e*t[0],i[1]+e*t[1],i[2]+e*t[2]],Ks=(i,t)=>[i[0]-t[0],i[1]-t[1],i[2]-t[2]],ei=(i,t)=>i[0]*t[0]+i[1]*t[1]+i[2]*t[2],ws=(i,t)=>[i[1]*t[2]-i[2]*t[1],i[2]*t[0]-i[0]*t[2],i[0]*t[1]-i[1]*t[0]],ni=i=>Math.hypot(i[0],i[1],i[2]),gn=(i,t=[0,0,1])=>{let e=ni(i);return e>1e-12?[i[0]/e,i[1]/e,i[2]/e]:t},yr=(i,t,e)=>[i[0]+e*(t[0]-i[0]),i[1]+e*(t[1]-i[1]),i[2]+e*(t[2]-i[2])],vr=i=>gn(ws(i,Math.abs(i[2])<.9?[0,0,1]:[1,0,0])),dh=class{constructor(t){this.tubes=t($f.tube),this.pipes=t($f.pipe),this.balls=t($f.ball)}begin(){}finish(){}tube(t,e,n,s){this.tubes.add(t,e,n,n,Eo(s))}cone(t,e,n,s,r){this.tubes.add(t,e,n,s,Eo(r))}ball(t,e,n){this.balls.add([t[0],t[1],t[2]-e],[t[0],t[1],t[2]+e],e,e,Eo(n))}line(t,e,n){for(let s=0;s+1<t.length;++s)this.pipes.add(t[s],t[s+1],e,e,Eo(n))}arrow(t,e,n,s){let r=Ks(e,t),o=ni(r);if(!(o>0))return;let a=Math.min(2.4*n,.6*o),l=yr(t,e,1-a/o),c=.5*n*a/(2.4*n);this.tube(t,l,.36*c,s),this.cone(l,e,c,0,s)}arc(t,e,n,s,r,o,a=!0){let l=vr(e),c=ws(e,l),h=12,u=[];for(let f=0;f<=h;++f){let d=2*Math.PI*s*f/h;u.push(ve(ve(t,l,n*Math.cos(d)),c,n*Math.sin(d)))}this.line(a?u.slice(0,h-1):u,.3*r,o),a&&this.cone(u[h-2],u[h],r,0,o)}};var Xw=`
attribute vec3 from, to, tint;
attribute vec2 radii;  // at both ends [m]
varying vec3 vColour, vEye;
void main() {
  vec3 axis = normalize(to - from + vec3(0.0, 0.0, 1e-12));
  vec3 side = normalize(cross(axis, abs(axis.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
  vec3 x = mix(from, to, position.z) + mix(radii.x, radii.y, position.z) * (position.x * side + position.y * cross(axis, side));
  vColour = tint;
  vec4 eye = modelViewMatrix * vec4(x, 1.0);
  vEye = eye.xyz;
  gl_Position = projectionMatrix * eye;
}`,qw=`
${So}
uniform float uOpacity;
varying vec3 vColour, vEye;
void main() {
  vec3 n = normalize(cross(dFdx(vEye), dFdy(vEye)));
  gl_FragColor = vec4(vColour * lightOn(n.z < 0.0 ? -n : n), uOpacity);
}`,Yw=6;function $w(i,t){return new Pn({vertexShader:Xw,fragmentShader:qw,uniforms:{uOpacity:{value:t}},transparent:t<1,...i})}var Jf=class{constructor(t){this.shape=t,this.geometry=new Oe,this.room=0,this.count=0}grow(){let{points:t,corners:e}=this.shape,n=this.arrays,s=Math.max(64,2*this.room),r=t.length,o=new Float32Array(3*r*s),a=new Uint32Array(e.length*s);for(let l=0;l<s;++l)t.forEach((c,h)=>o.set(c,3*(r*l+h))),e.forEach((c,h)=>a[e.length*l+h]=r*l+c);this.geometry.dispose(),this.arrays={from:new Float32Array(3*r*s),to:new Float32Array(3*r*s),tint:new Float32Array(3*r*s),radii:new Float32Array(2*r*s)},this.geometry.setIndex(new Ve(a,1)),this.geometry.setAttribute("position",new Ve(o,3));for(let[l,c]of Object.entries(this.arrays))n&&c.set(n[l]),this.geometry.setAttribute(l,new Ve(c,l==="radii"?2:3));this.room=s}add(t,e,n,s,r){this.count===this.room&&this.grow();let o=this.shape.points.length,{arrays:a}=this;for(let l=0,c=o*this.count;l<o;++l,++c)a.from[3*c]=t[0],a.from[3*c+1]=t[1],a.from[3*c+2]=t[2],a.to[3*c]=e[0],a.to[3*c+1]=e[1],a.to[3*c+2]=e[2],a.tint[3*c]=r[0],a.tint[3*c+1]=r[1],a.tint[3*c+2]=r[2],a.radii[2*c]=n,a.radii[2*c+1]=s;++this.count}finish(){if(this.room!==0){this.geometry.setDrawRange(0,this.shape.corners.length*this.count);for(let t of Object.keys(this.arrays))this.geometry.attributes[t].needsUpdate=!0}}},Mr=class extends dh{constructor({ghost:t=0,above:e=!1}={}){super(n=>new Jf(n)),this.ghosts=[],this.object=new Qe;for(let{geometry:n}of[this.tubes,this.pipes,this.balls]){let s=[[e?{depthTest:!1,depthWrite:!1}:{},1,e?10:1]];t>0&&s.push([{depthFunc:Yw,depthWrite:!1},t,2]);for(let[r,o,a]of s){let l=new tn(n,$w(r,o));l.frustumCulled=!1,l.renderOrder=a,o<1&&this.ghosts.push(l),this.object.add(l)}}}begin(){this.tubes.count=this.pipes.count=this.balls.count=0}showMeshes(t,e){for(let n of this.object.children)n.visible=this.ghosts.includes(n)?e:t}collect(t){for(let{shape:e,arrays:n,count:s}of[this.tubes,this.pipes,this.balls])for(let r=0;r<s;++r){let o=e.points.length*r,{from:a,to:l,radii:c,tint:h}=n;t.solid(a[3*o],a[3*o+1],a[3*o+2],l[3*o],l[3*o+1],l[3*o+2],c[2*o],c[2*o+1],e.sides,e.rows,h.subarray(3*o,3*o+3))}}finish(){this.tubes.finish(),this.pipes.finish(),this.balls.finish()}};var Zw="#c2006b",Jw=.22,Kw=1e-4,ph=class{constructor(t,e,n,s){Object.assign(this,{history:t,marks:s}),this.solids=new Mr({above:!0}),this.object=new Qe().add(this.solids.object),this.entries=[],this.rows=0,e.forEach((r,o)=>{let a=u=>u.map(f=>t.columns.get(`${r}.${f}`)?.values),l=s?.index("body",r)??-1,c=a(["contact.fx","contact.fy","contact.fz"]),h=a(["contact.mx","contact.my","contact.mz"]);!c.every(Boolean)&&l<0||this.entries.push({body:o,mark:l,force:c,moment:h,place:a(["x","y","z"])})}),this.largest=0,this.grow(),this.longest=Jw*n,this.width=.017*n}grow(){let{history:t,marks:e}=this,n=this.rows;this.rows=t.time.length;for(let{force:s,mark:r}of this.entries)if(s.every(Boolean))for(let o=n;o<this.rows;++o)this.largest=Math.max(this.largest,Math.hypot(s[0][o],s[1][o],s[2][o]));else for(let o=0;o<e.times.length;++o)this.largest=Math.max(this.largest,ni(e.vector(r,2,{k:o,next:o,mix:0})))}show(t,e,n=!0){if(this.solids.begin(),this.object.visible)for(let{body:s,mark:r,force:o,moment:a,place:l}of this.entries){let c=m=>m.map(p=>Ga(this.history,p,t)),h=this.marks?.moment(t,n),u=o.every(Boolean)?c(o):this.marks.vector(r,2,h),f=ni(u);if(!(f>Kw*this.largest))continue;let d=r>=0?this.marks.vector(r,0,h):l.every(Boolean)?c(l):e(s);if(d===null)continue;let g=o.every(Boolean)?a.every(Boolean)?c(a):null:this.marks.vector(r,3,h),x=g?ve(d,ws(u,g),1/ei(u,u)):d;this.solids.arrow(x,ve(x,gn(u),this.longest*Math.sqrt(f/this.largest)),this.width,Zw)}this.solids.finish()}};var Kf=8,jw=.62,d0=Array.from({length:256},(i,t)=>{let{shares:e,stops:n}=Xi.stress,s=t/255,r=1;for(;r<e.length-1&&s>e[r];)++r;let o=(s-e[r-1])/(e[r]-e[r-1]);return n[r].map((a,l)=>(n[r-1][l]+o*(a-n[r-1][l]))/255)});function Qw(i){let t=i.map(n=>[...n]),e=[[1,0,0],[0,1,0],[0,0,1]];for(let n=0;n<12;++n)for(let[s,r]of[[0,1],[0,2],[1,2]]){if(Math.abs(t[s][r])<1e-300)continue;let o=.5*Math.atan2(2*t[s][r],t[r][r]-t[s][s]),a=Math.cos(o),l=Math.sin(o);for(let c=0;c<3;++c)[t[c][s],t[c][r]]=[a*t[c][s]-l*t[c][r],l*t[c][s]+a*t[c][r]];for(let c=0;c<3;++c)[t[s][c],t[r][c]]=[a*t[s][c]-l*t[r][c],l*t[s][c]+a*t[r][c]];for(let c=0;c<3;++c)[e[c][s],e[c][r]]=[a*e[c][s]-l*e[c][r],l*e[c][s]+a*e[c][r]]}return[0,1,2].map(n=>({value:t[n][n],axis:e.map(s=>s[n])}))}function t1(i,t){let e=(B,F)=>F.map((I,z)=>I-B[z]),n=(B,F)=>B[0]*F[0]+B[1]*F[1]+B[2]*F[2],s=(B,F)=>Math.min(1,Math.max(0,n(e(B,F),e(B,t))/(n(e(B,F),e(B,F))||1))),[r,o,a]=i;if(i.length===2)return[1-s(r,o),s(r,o)];let l=e(r,o),c=e(r,a),h=e(r,t),u=e(o,t),f=e(a,t),d=n(l,h),g=n(c,h),x=n(l,u),m=n(c,u),p=n(l,f),v=n(c,f),A=x*v-p*m,M=p*g-d*v,C=d*m-x*g,S=A+M+C;if(A>0&&M>0&&C>0)return[A/S,M/S,C/S];let _=[[0,1],[1,2],[2,0]].map(([B,F])=>{let I=s(i[B],i[F]),z=i[B].map((X,V)=>X+I*(i[F][V]-X));return{i:B,j:F,s:I,distance:Math.hypot(z[0]-t[0],z[1]-t[1],z[2]-t[2])}}),{i:E,j:U,s:D}=_.reduce((B,F)=>F.distance<B.distance?F:B),L=[0,0,0];return L[E]+=1-D,L[U]+=D,L}var mh=class{constructor(t,e,n="",s=null){Object.assign(this,{spec:t,prefix:n}),this.colours=s?e.map(()=>s):Id(e),this.times=t.times,this.frames=[],this.shown=[0,0],this.mix=0}async loadFirst(){let t=async(n,s)=>Jn(await os(`${this.prefix}bodies-${n}`),s);this.triangles=await t("triangles",Uint32Array),this.lines=await t("lines",Uint32Array),this.cellBody=await t("cells",Uint32Array),this.radius=await t("radius",Float32Array),this.decoder=new rs(3*this.spec.points+(this.spec.stress>0?this.spec.cells:0)),await this.loadNext(),this.marked=this.turningMarks();let e=new Map;for(let n of this.lines)e.set(n,(e.get(n)??0)+1);this.openEnds=Array.from({length:this.lines.length/2},(n,s)=>[0,1].filter(r=>e.get(this.lines[2*s+r])===1)),this.profiles=this.openEnds.map(n=>[...n.includes(0)?[[0,0]]:[],[0,1],[1,1],...n.includes(1)?[[1,0]]:[]])}async loadNext(){let t=this.frames.length;if(t===this.times.length)return!1;let e=await os(`${this.prefix}bodies-${t}`);return this.add(e instanceof Uint16Array?e:this.decoder.next(e)),!0}add(t){this.frames.push(t)}moment(t,e){let n=this.frames.length-1,s=Math.min(er(this.times,t),n),r=e?Math.min(s+1,n):s,o=this.times[r]-this.times[s];return this.mix=o>0?Math.min(1,Math.max(0,(t-this.times[s])/o)):0,this.shown=[s,r]}ownTint(t){let e=Eo(this.colours[this.cellBody[t]%this.colours.length]??"#8fa6bd");return this.marked.has(t)?e.map(n=>n*jw):e}turningMarks(){let t=new Set,e=this.triangles.length/3,n=new Map;for(let s=0;s<e;++s)n.has(this.cellBody[s])?n.get(this.cellBody[s]).push(s):n.set(this.cellBody[s],[s]);for(let s of n.values()){if(s.length<24)continue;let r=[...new Set(s.flatMap(A=>this.cornersOf(A)))].map(A=>this.pointOf(this.frames[0],A)),o=r.length,a=[0,1,2].map(A=>r.reduce((M,C)=>M+C[A],0)/o),l=[0,1,2].map(A=>[0,1,2].map(M=>r.reduce((C,S)=>C+(S[A]-a[A])*(S[M]-a[M]),0)/o)),[c,h,u]=Qw(l).sort((A,M)=>A.value-M.value),f=(A,M)=>Math.abs(A.value-M.value)<.03*u.value;if(!f(c,h)&&!f(h,u))continue;let d=f(h,u)?c:u,g=f(h,u)?h.axis:c.axis,x=[d.axis[1]*g[2]-d.axis[2]*g[1],d.axis[2]*g[0]-d.axis[0]*g[2],d.axis[0]*g[1]-d.axis[1]*g[0]],m=r.map(A=>A.map((M,C)=>M-a[C])).map(A=>[A[0]*g[0]+A[1]*g[1]+A[2]*g[2],A[0]*x[0]+A[1]*x[1]+A[2]*x[2]]),p=Math.max(...m.map(([A,M])=>Math.hypot(A,M)));if(!(new Set(m.filter(([A,M])=>Math.hypot(A,M)>.9*p).map(([A,M])=>Math.floor((Math.atan2(M,A)+Math.PI)*(6/Math.PI))%12)).size<10))for(let A of s){let M=this.cornersOf(A).map(E=>this.pointOf(this.frames[0],E)),C=[0,1,2].map(E=>M.reduce((U,D)=>U+D[E],0)/3-a[E]),S=E=>E[0]*C[0]+E[1]*C[1]+E[2]*C[2];(Math.atan2(S(x),S(g))+2*Math.PI)%Math.PI<Math.PI/4&&t.add(A)}}return t}collect(t,e=!1){let{low:n,size:s}=this.spec.box,r=this.spec.points,{mix:o}=this,[a,l]=this.shown.map(x=>this.frames[x]),c=this.at??=new Float64Array(3*r),h=this.triangles.length/3;for(let x=0;x<3;++x)for(let m=0,p=x*r;m<r;++m,++p)c[3*m+x]=n[x]+s[x]*(a[p]+o*(l[p]-a[p]))/65534;let u=e&&this.spec.stress>0,f=this.colours.map((x,m)=>this.spec.stressed.includes(m)),d=x=>{let m=this.cellBody[x];return!u||!f[m]?this.ownTint(x):d0[Math.round((a[3*r+x]+o*(l[3*r+x]-a[3*r+x]))/65535*(d0.length-1))]},g=[0,1,2].map(()=>[0,0,0]);for(let x=0;x<h;++x){for(let m=0;m<3;++m){let p=3*this.triangles[3*x+m];t.toEye(c[p],c[p+1],c[p+2],g[m])}t.add(g,d(x),!0)}for(let x=0;2*x<this.lines.length;++x){let m=3*this.lines[2*x],p=3*this.lines[2*x+1],v=this.radius[x];t.solid(c[m],c[m+1],c[m+2],c[p],c[p+1],c[p+2],v,v,Kf,this.profiles[x],d(h+x))}}has(t){return this.cellsOf??=this.cellsByBody(),this.cellsOf.has(t)}cellsByBody(){let t=new Map;return this.cellBody.forEach((e,n)=>t.has(e)?t.get(e).push(n):t.set(e,[n])),t}cornersOf(t){let e=this.triangles.length/3;return t<e?[0,1,2].map(n=>this.triangles[3*t+n]):[0,1].map(n=>this.lines[2*(t-e)+n])}pointOf(t,e){let{low:n,size:s}=this.spec.box,r=this.spec.points;return[0,1,2].map(o=>n[o]+s[o]*t[o*r+e]/65534)}nearest(t,e){if(!this.has(t))return null;let n=this.triangles.length/3,s=null;for(let r of this.cellsOf.get(t)){let o=this.cornersOf(r),a=t1(o.map(h=>this.pointOf(this.frames[0],h)),e),l=[0,1,2].map(h=>o.reduce((u,f,d)=>u+a[d]*this.pointOf(this.frames[0],f)[h],0)),c=Math.max(0,Math.hypot(l[0]-e[0],l[1]-e[1],l[2]-e[2])-(r<n?0:this.radius[r-n]));(!s||c<s.gap)&&(s={corners:o,weights:a,gap:c})}return s}place({corners:t,weights:e}){let{mix:n}=this,[s,r]=this.shown.map(a=>this.frames[a]),o=[0,0,0];return t.forEach((a,l)=>{let c=this.pointOf(s,a),h=this.pointOf(r,a);for(let u=0;u<3;++u)o[u]+=e[l]*(c[u]+n*(h[u]-c[u]))}),o}centre(t){this.pointsOf??=this.pointsByBody();let e=this.pointsOf.get(t);if(!e)return null;let{low:n,size:s}=this.spec.box,r=this.spec.points,o=this.uniforms.uMix.value,[a,l]=this.shown.map(c=>this.frames[c]);return[0,1,2].map(c=>{let h=0;for(let u of e)h+=a[c*r+u]+o*(l[c*r+u]-a[c*r+u]);return n[c]+s[c]*h/e.length/65534})}pointsByBody(){let t=new Map,e=(s,r)=>{let o=this.cellBody[s];t.has(o)||t.set(o,new Set),t.get(o).add(r)},n=this.triangles.length/3;return this.triangles.forEach((s,r)=>e(r/3|0,s)),this.lines.forEach((s,r)=>e(n+(r/2|0),s)),new Map([...t].map(([s,r])=>[s,[...r]]))}};var p0=`
uniform bool uStress;
attribute vec4 tint;  // the last: its stress is known
varying vec3 vColour, vEye;
varying float vBehind;  // how far the clip plane leaves it out [m]
void paint(float stress, vec3 x) {
  vColour = uStress && tint.w > 0.5 ? colourOf(stress) : tint.rgb;
  vec4 eye = modelViewMatrix * vec4(x, 1.0);
  vEye = eye.xyz;
  gl_Position = projectionMatrix * eye;
  vBehind = dot(x, uClip.xyz) - uClip.w;
}`,e1=`
${Ia}${La}${Da}${p0}
attribute vec4 a, b;
void main() {
  paint(mix(a.w, b.w, uMix), placed(a, b));
}`,n1=`
${Ia}${La}${Da}${p0}
attribute vec4 a0, a1, b0, b1;
attribute float radius;
void main() {
  vec3 from = placed(a0, b0), to = placed(a1, b1), axis = normalize(to - from + vec3(0.0, 0.0, 1e-12));
  vec3 side = normalize(cross(axis, abs(axis.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
  vec3 x = mix(from, to, position.z) + radius * (position.x * side + position.y * cross(axis, side));
  paint(mix(a0.w, b0.w, uMix), x);
}`,i1=`
${So}
varying vec3 vColour, vEye;
varying float vBehind;
uniform float uOpaque;
void main() {
  if (vBehind > 0.0) discard;
  vec3 n = normalize(cross(dFdx(vEye), dFdy(vEye)));
  gl_FragColor = vec4(vColour * lightOn(n.z < 0.0 ? -n : n), uOpaque);
}`,To=(()=>{let i=Kf,t=[],e=[],n=[[],[]];for(let s=0;s<2*i;++s){let r=2*Math.PI*(s%i)/i;t.push([Math.cos(r),Math.sin(r),s<i?0:1])}t.push([0,0,0],[0,0,1]);for(let s=0;s<i;++s){let r=(s+1)%i;e.push(s,r,i+r,s,i+r,i+s),n[0].push(r,s,2*i),n[1].push(i+s,i+r,2*i+1)}return{sides:i,points:t,corners:e,ends:n}})(),s1="#8338ec",Na=class i extends mh{constructor(t,e,n=!1){super(t,e,n?"other-":"",n?s1:null),this.ghost=n,this.uniforms={...lh(Xi.stress),...ch(t.box),uClip:{value:new De},uStress:{value:!1},uOpaque:{value:n?.35:1}},this.object=new Qe,this.filled=[-1,-1]}material(t){return new Pn({vertexShader:t,fragmentShader:i1,uniforms:this.uniforms,side:Dn,...this.ghost?{transparent:!0,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}:{}})}async loadFirst(){await super.loadFirst();let t=this.triangles.length/3,e=this.lines.length/2,n=(o,a)=>{let l=new Float32Array(4*a*o.length);return o.forEach((c,h)=>{let u=[...this.ownTint(c),this.spec.stressed.includes(this.cellBody[c])?1:0];for(let f=0;f<a;++f)l.set(u,4*(a*h+f))}),l},s=(o,a)=>Array.from({length:a},(l,c)=>o+c),r=o=>new Ve(new Uint16Array(4*o),4,!0);if(t>0){let o=new Oe;o.setAttribute("tint",new Ve(n(s(0,t),3),4));for(let a of["a","b"])o.setAttribute(a,r(3*t));o.setAttribute("position",o.attributes.a),this.plates=new tn(o,this.material(e1))}if(e>0){let o=new Oe;o.setIndex(this.tubeCorners()),o.setAttribute("position",new Ge(Array(e).fill(To.points.flat()).flat(),3));let a=To.points.length;o.setAttribute("tint",new Ve(n(s(t,e),a),4)),o.setAttribute("radius",new Ve(Float32Array.from({length:a*e},(l,c)=>this.radius[c/a|0]),1));for(let l of["a0","a1","b0","b1"])o.setAttribute(l,r(a*e));this.tubes=new tn(o,this.material(n1))}for(let o of[this.plates,this.tubes])o&&(o.frustumCulled=!1,this.object.add(o));this.show(this.times[0],!0)}tubeCorners(){let t=[];return this.openEnds.forEach((e,n)=>{for(let s of[To.corners,...e.map(r=>To.ends[r])])for(let r of s)t.push(n*To.points.length+r)}),t}static put(t,e,n,s,r,o){t[4*e]=n[r],t[4*e+1]=n[s+r],t[4*e+2]=n[2*s+r],t[4*e+3]=o}fill(t,e){let n=this.frames[e],s=this.spec.points,r=this.triangles.length/3,o=a=>this.spec.stress>0?n[3*s+a]:0;if(this.plates){let a=this.plates.geometry.attributes[t];for(let l=0;l<this.triangles.length;++l)i.put(a.array,l,n,s,this.triangles[l],o(l/3|0));a.needsUpdate=!0}if(this.tubes)for(let a of[0,1]){let l=this.tubes.geometry.attributes[t+a],c=To.points.length;for(let h=0;h<c*this.lines.length/2;++h){let u=h/c|0;i.put(l.array,h,n,s,this.lines[2*u+a],o(r+u))}l.needsUpdate=!0}}show(t,e){let[n,s]=this.moment(t,e);return this.uniforms.uMix.value=this.mix,this.filled[0]!==n&&this.fill("a",n),this.filled[1]!==s&&this.fill("b",s),this.filled=[n,s],n}collect(t){let e=this.uniforms.uClip.value;return(e.x||e.y||e.z)&&e.w<1e29?!1:(super.collect(t,this.uniforms.uStress.value),!0)}showMeshes(t){for(let e of this.object.children)e.visible=t}};function jf(i){let t=gn(ve([1,0,0],i,-i[0]),[0,1,0]);return{x:t,y:ws(i,t),z:i}}function m0(i,t,e){let n=i*Math.PI/180,s=t*Math.PI/180,{x:r,y:o,z:a}=jf(e);return[0,1,2].map(l=>Math.cos(s)*Math.cos(n)*r[l]+Math.cos(s)*Math.sin(n)*o[l]+Math.sin(s)*a[l])}var Ua=16383,gh=class i{constructor(){this.points=new Float64Array(32768),this.firsts=new Uint32Array(4096),this.colours=new Int32Array(4096),this.corners=Array.from({length:64},()=>new Float64Array(3)),this.polygon=[]}begin(t,e,n){this.V=t.matrixWorldInverse.elements,this.near=t.near,this.perPixel=t.projectionMatrix.elements[5]*.5*n,Object.assign(this,{width:e,height:n,count:0,used:0,nearest:1/0,farthest:0,left:e,right:0,bottom:n,top:0}),this.whole=!0}toEye(t,e,n,s){let r=this.V;s[0]=r[0]*t+r[4]*e+r[8]*n+r[12],s[1]=r[1]*t+r[5]*e+r[9]*n+r[13],s[2]=r[2]*t+r[6]*e+r[10]*n+r[14]}add(t,e,n=!1){let s=t.length;3*(this.used+s)>this.points.length&&(this.points=i.grown(this.points)),this.count+2>this.firsts.length&&([this.firsts,this.colours]=[i.grown(this.firsts),i.grown(this.colours)]);let{points:r}=this,o=1/0,a=-1/0,l=1/0,c=-1/0,h=1/0,u=0;for(let F=0,I=3*this.used;F<s;++F,I+=3){let z=t[F],X=-z[2];if(X<this.near){this.whole=!1;return}let V=this.perPixel/X,ot=r[I]=.5*this.width+V*z[0],q=r[I+1]=.5*this.height+V*z[1];r[I+2]=1/X,ot<o&&(o=ot),ot>a&&(a=ot),q<l&&(l=q),q>c&&(c=q),X<h&&(h=X),X>u&&(u=X)}if(a<0||c<0||o>this.width||l>this.height)return;let f=0;for(let F=0,I=3*this.used,z=I+3*(s-1);F<s;++F,z=I,I+=3)f+=r[z]*r[I+1]-r[I]*r[z+1];if(n?f===0:f<=0)return;let d=t[0],g=t[1],x=t[s>>1],m=t[s===3?2:(s>>1)+1],p=s===3?d:g,v=(s===3?g[0]:x[0])-d[0],A=(s===3?g[1]:x[1])-d[1],M=(s===3?g[2]:x[2])-d[2],C=m[0]-p[0],S=m[1]-p[1],_=m[2]-p[2],E=A*_-M*S,U=M*C-v*_,D=v*S-A*C,L=(D<0?-1:1)*(Math.sqrt(E*E+U*U+D*D)||1),B=63*wo(E/L,U/L,D/L);this.colours[this.count]=Math.round(e[0]*B)<<26|Math.round(e[1]*B)<<20|Math.round(e[2]*B)<<14,this.firsts[this.count]=this.used,this.used+=s,this.firsts[++this.count]=this.used,this.left=Math.min(this.left,o),this.right=Math.max(this.right,a),this.bottom=Math.min(this.bottom,l),this.top=Math.max(this.top,c),this.nearest=Math.min(this.nearest,h),this.farthest=Math.max(this.farthest,u)}static grown(t){let e=new t.constructor(2*t.length);return e.set(t),e}solid(t,e,n,s,r,o,a,l,c,h,u){let{V:f,corners:d,polygon:g}=this,x=s-t,m=r-e,p=o-n+1e-12,v=Math.hypot(x,m,p);x/=v,m/=v,p/=v;let A=Math.abs(p)>=.9,M=A?Math.hypot(m,p):Math.hypot(x,m),C=A?0:m/M,S=(A?p:-x)/M,_=A?-m/M:0,E=m*_-p*S,U=p*C-x*_,D=x*S-m*C,L=f[0]*C+f[4]*S+f[8]*_,B=f[1]*C+f[5]*S+f[9]*_,F=f[2]*C+f[6]*S+f[10]*_,I=f[0]*E+f[4]*U+f[8]*D,z=f[1]*E+f[5]*U+f[9]*D,X=f[2]*E+f[6]*U+f[10]*D,V=d[63],ot=i.turns(c);h.forEach(([q,j],tt)=>{this.toEye(t+q*(s-t),e+q*(r-e),n+q*(o-n),V);let lt=j*(a+q*(l-a));for(let it=0;it<c;++it){let Z=lt*ot[2*it],ft=lt*ot[2*it+1],dt=d[tt*c+it];dt[0]=V[0]+Z*L+ft*I,dt[1]=V[1]+Z*B+ft*z,dt[2]=V[2]+Z*F+ft*X}});for(let q=0;q+1<h.length;++q){let j=q*c;if(h[q][0]===h[q+1][0]){let lt=h[q][1]===0,it=lt?j+c:j;if((lt?a:l)===0)continue;g.length=c;for(let Z=0;Z<c;++Z)g[Z]=d[it+(lt?c-1-Z:Z)];this.add(g,u);continue}g.length=4;for(let lt=0;lt<c;++lt){let it=(lt+1)%c;g[0]=d[j+lt],g[1]=d[j+it],g[2]=d[j+c+it],g[3]=d[j+c+lt],this.add(g,u)}}}static turns(t){return i.known??=new Map,i.known.has(t)||i.known.set(t,Float64Array.from({length:2*t},(e,n)=>(n%2?Math.sin:Math.cos)(2*Math.PI*(n>>1)/t))),i.known.get(t)}fill(t,e,n){let{points:s,firsts:r,colours:o,width:a,height:l}=this;for(let c=0;c<this.count;++c){let h=3*r[c],u=3*r[c+1],f=1/0,d=-1/0;for(let S=h;S<u;S+=3)s[S+1]<f&&(f=s[S+1]),s[S+1]>d&&(d=s[S+1]);let g=s[h],x=s[h+1],m=s[h+2],p=0,v=0,A=0;for(let S=h+3;S+3<u;S+=3){let _=s[S]-g,E=s[S+1]-x,U=s[S+2]-m,D=s[S+3]-g,L=s[S+4]-x,B=s[S+5]-m,F=_*L-E*D;Math.abs(F)<=p||(p=Math.abs(F),v=(U*L-B*E)/F,A=(_*B-D*U)/F)}let M=Math.min(l-1,Math.ceil(d-.5)-1),C=o[c];for(let S=Math.max(0,Math.ceil(f-.5));S<=M;++S){let _=S+.5,E=1/0,U=-1/0;for(let F=h,I=u-3;F<u;I=F,F+=3){let z=s[I+1],X=s[F+1];if(z<=_==X<=_)continue;let V=s[I]+(_-z)/(X-z)*(s[F]-s[I]);V<E&&(E=V),V>U&&(U=V)}let D=Math.min(a-1,Math.ceil(U-.5)-1),L=Math.max(0,Math.ceil(E-.5)),B=m+v*(L+.5-g)+A*(_-x);for(let F=S*a+L;F<=S*a+D;++F,B+=v){let I=Math.min(Ua,Math.max(1,1+((1/B-e)/n|0))),z=t[F]&Ua;(z===0||I<z)&&(t[F]=C|I)}}}}};var Ao=64,br=128,Oi=64,r1=`
uniform vec4 uBounds;  // of the picture that holds grains, -1 ... 1
void main() { gl_Position = vec4(mix(uBounds.xy, uBounds.zw, position.xy), 0.0, 1.0); }`,o1=`
precision highp usampler2D;
uniform usampler2D uPixels;
uniform float uNear, uStep;
uniform mat4 uProjection;
void main() {
  uint pixel = texelFetch(uPixels, ivec2(gl_FragCoord.xy), 0).r;
  if (pixel == 0u) discard;
  gl_FragColor = vec4(vec3((uvec3(pixel) >> uvec3(26u, 20u, 14u)) & 63u) / 63.0, 1.0);
  gl_FragDepth = 0.5 + 0.5 * (uProjection[3][2] / (uNear + uStep * float((pixel & 16383u) - 1u)) - uProjection[2][2]);
}`,xh=class{constructor(t,e,n){this.discs=new Float32Array(4*t),this.grain=new Uint32Array(t),this.steps=new Uint16Array(t),this.order=new Uint32Array(t),this.places=new Uint32Array(Ua+2),this.makeTables(e,n);let s=new Oe;s.setAttribute("position",new Ve(new Float32Array([0,0,0,1,0,0,0,1,0,0,1,0,1,0,0,1,1,0]),3)),this.uniforms={uPixels:{value:null},uBounds:{value:new De},uNear:{value:0},uStep:{value:0},uProjection:{value:null}},this.object=new tn(s,new Pn({vertexShader:r1,fragmentShader:o1,uniforms:this.uniforms})),this.object.frustumCulled=!1}makeTables(t,e){this.light=new Uint8Array(Oi*Oi);let n=.42,s=1;for(let r=0;r<Oi;++r)for(let o=0;o<Oi;++o){let a=(2*o+1)/Oi-1,l=(2*r+1)/Oi-1,c=Math.sqrt(Math.max(0,1-a*a-l*l)),h=(e(a,l,c)-n)/(s-n);this.light[r*Oi+o]=Math.round((Ao-1)*Math.min(1,Math.max(0,h)))}this.palette=new Int32Array(2*br*Ao);for(let r=0;r<2*br;++r){let o=r%br/(br-1),a=r<br?1:.8+(1-.8)*Math.min(1,o/.12),l=1;for(;l<t.shares.length-1&&o>t.shares[l];)++l;let c=(o-t.shares[l-1])/(t.shares[l]-t.shares[l-1]);for(let h=0;h<Ao;++h)for(let u=0;u<3;++u){let f=t.stops[l-1][u]+c*(t.stops[l][u]-t.stops[l-1][u]),d=Math.min(63,Math.round(a*f*(n+(s-n)*h/(Ao-1))*63/255));this.palette[r*Ao+h]|=d<<26-6*u}}}resize(t,e){if(this.width===t&&this.height===e)return;Object.assign(this,{width:t,height:e}),this.uniforms.uPixels.value?.dispose(),this.pixels=new Int32Array(t*e);let n=new ho(new Uint32Array(this.pixels.buffer),t,e,yo,_i);n.internalFormat="R32UI",this.uniforms.uPixels.value=n,this.words=Math.ceil(t/32),this.free=new Int32Array(this.words*e)}paint({a:t,b:e,mix:n,box:s,radius:r,camera:o,clip:a,width:l,height:c,share:h,odd:u,facets:f}){this.resize(l,c);let{nearest:d,step:g,count:x}=this.place({a:t,b:e,mix:n,box:s,radius:r,camera:o,clip:a,width:l,height:c,facets:f});return this.sort(x,d,g),this.pixels.fill(0),this.free.fill(-1),this.discsOf(x,h,u,e,n),f?.fill(this.pixels,d,g),this.uniforms.uNear.value=d,this.uniforms.uStep.value=g,this.uniforms.uProjection.value=o.projectionMatrix,this.uniforms.uPixels.value.needsUpdate=!0,x}place({a:t,b:e,mix:n,box:s,radius:r,camera:o,clip:a,width:l,height:c,facets:h}){let{discs:u,grain:f}=this,d=o.matrixWorldInverse.elements,g=o.projectionMatrix.elements[5]*.5*c,{low:x,size:m}=s,p=m[0]/65534,v=m[1]/65534,A=m[2]/65534,M=o.near,C=d[0]*p,S=d[4]*v,_=d[8]*A,E=d[0]*x[0]+d[4]*x[1]+d[8]*x[2]+d[12],U=d[1]*p,D=d[5]*v,L=d[9]*A,B=d[1]*x[0]+d[5]*x[1]+d[9]*x[2]+d[13],F=-d[2]*p,I=-d[6]*v,z=-d[10]*A,X=-(d[2]*x[0]+d[6]*x[1]+d[10]*x[2]+d[14]),V=a.x*p,ot=a.y*v,q=a.z*A,j=a.x*x[0]+a.y*x[1]+a.z*x[2]-a.w,{nearest:tt,farthest:lt,left:it,right:Z,bottom:ft,top:dt}=h??{nearest:1/0,farthest:0,left:l,right:0,bottom:c,top:0},Mt=0;for(let kt=0,Wt=0;kt<r.length;++kt,Wt+=4){let Nt=t[Wt],ee=t[Wt+1],jt=t[Wt+2];if(Nt===65535||(e[Wt]!==65535&&(Nt+=n*(e[Wt]-Nt),ee+=n*(e[Wt+1]-ee),jt+=n*(e[Wt+2]-jt)),V*Nt+ot*ee+q*jt+j>0))continue;let Xt=F*Nt+I*ee+z*jt+X;if(Xt<M)continue;let Ne=g/Xt,ae=Math.max(.5,Ne*r[kt]),Ue=.5*l+Ne*(C*Nt+S*ee+_*jt+E),ge=.5*c+Ne*(U*Nt+D*ee+L*jt+B);if(Ue<-ae||ge<-ae||Ue>l+ae||ge>c+ae)continue;let Ke=4*Mt;u[Ke]=Ue,u[Ke+1]=ge,u[Ke+2]=ae,u[Ke+3]=Xt,f[Mt++]=kt,Xt<tt&&(tt=Xt),Xt>lt&&(lt=Xt),Ue-ae<it&&(it=Ue-ae),Ue+ae>Z&&(Z=Ue+ae),ge-ae<ft&&(ft=ge-ae),ge+ae>dt&&(dt=ge+ae)}let gt=(kt,Wt)=>Math.min(1,Math.max(-1,2*kt/Wt-1));return this.uniforms.uBounds.value.set(gt(it-1,l),gt(ft-1,c),gt(Z+1,l),gt(dt+1,c)),{nearest:tt,step:(lt-tt||1)/(Ua-1),count:Mt}}sort(t,e,n){let{places:s,steps:r,order:o,discs:a}=this;s.fill(0);for(let l=0;l<t;++l)++s[(r[l]=1+((a[4*l+3]-e)/n|0))+1];for(let l=1;l<s.length;++l)s[l]+=s[l-1];for(let l=0;l<t;++l)o[s[r[l]]++]=l}discsOf(t,e,n,s,r){let{width:o,height:a,pixels:l,light:c,palette:h,free:u,words:f,discs:d,order:g,grain:x,steps:m}=this;for(let p=0;p<t;++p){let v=g[p],A=d[4*v],M=d[4*v+1],C=d[4*v+2],S=Math.max(0,Math.ceil(A-C-.5)),_=Math.min(o-1,Math.floor(A+C-.5)),E=Math.min(a-1,Math.floor(M+C-.5));if(_<S)continue;let U=S>>5,D=_>>5,L=-1<<(S&31),B=-1>>>31-(_&31),F=(.5*Oi-.01)/C,I=-1;for(let z=Math.max(0,Math.ceil(M-C-.5));z<=E;++z){let X=z*f,V=U===D?u[X+U]&L&B:u[X+U]&L|u[X+D]&B;for(let it=U+1;it<D;++it)V|=u[X+it];if(V===0)continue;let ot=z+.5-M,q=Math.sqrt(Math.max(0,C*C-ot*ot)),j=Math.max(0,Math.ceil(A-q-.5)),tt=Math.min(o-1,Math.floor(A+q-.5)),lt=Oi*(ot*F+.5*Oi|0);for(let it=j>>5;it<=tt>>5;++it){let Z=u[X+it];for(it===j>>5&&(Z&=-1<<(j&31)),it===tt>>5&&(Z&=-1>>>31-(tt&31)),u[X+it]&=~Z;Z!==0;Z&=Z-1){let ft=32*it+31-Math.clz32(Z&-Z);if(I<0){let dt=x[v];I=Ao*(n[dt]*br+Math.round((br-1)*Math.min(1,Math.max(0,e(dt,s[4*dt]===65535?0:r)))))}l[z*o+ft]=h[I+c[lt+((ft+.5-A)*F+.5*Oi|0)]]|m[v]}}}}}};var a1=`
${Ia}${La}${Da}
attribute vec4 a, b, start;
attribute float radius;
uniform float uPixels;       // height of the picture [pixels]
uniform int uColour;         // 0 plain, 1 the frame's number, 2 displacement since the first frame
uniform float uLargest;      // displacement at the end of the colours [m]
uniform float uUpper;        // share of the largest number at the end of the colours
uniform float uLayers;       // in the box
flat out vec3 vColour;
void main() {
  bool lastKnown = b.x >= 1.0;
  vec4 next = lastKnown ? a : b;
  vec3 x = placed(a, next);
  float value = mix(a.w, next.w, uMix);
  float share = 0.0;
  if (uColour == 1) share = value * value / uUpper;
  if (uColour == 2) share = start.x >= 1.0 ? 0.0 : length(x - (uLow + uSize * (65535.0 / 65534.0) * start.xyz)) / uLargest;
  vColour = colourOf(share);
  if (start.x < 1.0 && fract(0.5 * floor(start.z * uLayers)) > 0.25) vColour *= mix(${.8.toFixed(3)}, 1.0, min(1.0, share / ${.12.toFixed(3)}));
  vec4 eye = modelViewMatrix * vec4(x, 1.0);
  gl_Position = projectionMatrix * eye;
  gl_PointSize = max(1.0, radius * projectionMatrix[1][1] * uPixels / gl_Position.w);
  if (a.x >= 1.0 || clipped(x)) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
}`,l1=`
${So}
flat in vec3 vColour;
void main() {
  vec2 p = 2.0 * gl_PointCoord - 1.0;
  float h = 1.0 - dot(p, p);
  if (h < 0.0) discard;
  gl_FragColor = vec4(vColour * lightOn(vec3(p.x, -p.y, sqrt(h))), 1.0);
}`,yh=class{constructor(t){this.spec=t,this.times=t.times,this.frames=[],this.geometry=new Oe,this.material=new Pn({vertexShader:a1,fragmentShader:l1,uniforms:{...lh(Xi.sand),...ch(t.box),uClip:{value:new De},uPixels:{value:1},uColour:{value:0},uLargest:{value:1},uUpper:{value:1},uLayers:{value:1}}}),this.all=new la(this.geometry,this.material),this.all.frustumCulled=!1,this.object=new Qe().add(this.all)}async loadFirst(){let t=await os("grains-radius"),e=t instanceof Float32Array?t:Jn(t,Float32Array);this.geometry.setAttribute("radius",new Ve(e,1)),this.radius=e,this.decoder=new rs(this.spec.count*(3+this.spec.numbers.length)),await this.loadNext(),this.geometry.setAttribute("start",this.frames[0].positions),this.findLayers(),this.setNumber(0),this.show(this.times[0],!0)}findLayers(){let{low:t,high:e}=this.spec.view,n=e[2]-t[2],s=this.frames[0].positions.array,r=this.spec.count,o=Math.max(n/6,3*this.radius.reduce((c,h)=>c+h,0)/Math.max(1,r))||1,a=10**Math.floor(Math.log10(o));this.layer=[1,2,5,10].map(c=>c*a).find(c=>c>=.99*o)??10*a;let l=(this.spec.box.size[2]||this.layer)/this.layer;this.material.uniforms.uLayers.value=l,this.odd=Uint8Array.from({length:r},(c,h)=>s[4*h]===65535?0:Math.floor(s[4*h+2]/65535*l)&1)}async loadNext(){let t=this.frames.length;if(t===this.times.length)return!1;let e=await os(`grains-${t}`);return this.add(e instanceof Uint16Array?e:this.decoder.next(e)),!0}add(t){let e=this.spec.count,n=new Uint16Array(4*e);for(let r=0;r<e;++r)n[4*r]=t[r],n[4*r+1]=t[e+r],n[4*r+2]=t[2*e+r];let s=this.spec.numbers.map((r,o)=>t.slice((3+o)*e,(4+o)*e));this.frames.push({positions:new Ve(n,4,!0),numbers:s}),this.frames.length>1&&this.fill(this.frames.at(-1))}fill(t){let e=t.numbers[this.number],n=t.positions.array;if(e)for(let s=0;s<this.spec.count;++s)n[4*s+3]=e[s]*257;t.positions.needsUpdate=!0}setNumber(t){this.number=t;for(let e of this.frames)this.fill(e)}colours(){return[...this.spec.numbers.map(e=>({name:e.name,unit:e.unit,largest:e.shown})),{name:"displacement",unit:"m",largest:this.spec.farthest},{name:"plain"}]}setColour(t){let e=this.material.uniforms,n=this.spec.numbers.findIndex(s=>s.name===t);n>=0?(e.uColour.value=1,e.uUpper.value=this.spec.numbers[n].shown/this.spec.numbers[n].largest,n!==this.number&&this.setNumber(n)):(e.uColour.value=t==="displacement"?2:0,e.uLargest.value=this.spec.farthest||1)}show(t,e){let n=this.frames.length-1,s=Math.min(er(this.times,t),n),r=Math.min(s+1,n),o=this.times[r]-this.times[s];return this.material.uniforms.uMix.value=e&&o>0?Math.min(1,Math.max(0,(t-this.times[s])/o)):0,this.geometry.setAttribute("a",this.frames[s].positions),this.geometry.setAttribute("b",this.frames[e?r:s].positions),this.geometry.setAttribute("position",this.frames[s].positions),this.shown=[this.frames[s],this.frames[e?r:s]],s}paint(t,e,n,s,r){if(this.all.visible=!t,this.painter&&(this.painter.object.visible=t),!t)return;this.painter||(this.painter=new xh(this.spec.count,Xi.sand,wo),this.object.add(this.painter.object));let o=this.material.uniforms,[a,l]=this.shown.map(h=>h.positions.array),c={a,b:l,mix:o.uMix.value,box:this.spec.box,radius:this.radius,camera:e,clip:o.uClip.value,width:n,height:s};this.painter.paint({...c,share:this.shareOfColours(a,l),odd:this.odd,facets:r})}shareOfColours(t,e){let n=this.material.uniforms,s=n.uColour.value;if(s===1){let l=n.uUpper.value*65535*65535;return(c,h)=>{let u=t[4*c+3]+h*(e[4*c+3]-t[4*c+3]);return u*u/l}}if(s!==2)return()=>0;let r=this.frames[0].positions.array,o=n.uLargest.value,{size:a}=this.spec.box;return(l,c)=>{let h=4*l;if(r[h]===65535)return 0;let u=0;for(let f=0;f<3;++f){let d=a[f]*(t[h+f]+c*(e[h+f]-t[h+f])-r[h+f])/65534;u+=d*d}return Math.sqrt(u)/o}}};var td=12,vh=class{constructor(t){this.times=t.times,this.list=t.list,this.byName=new Map(t.list.map((e,n)=>[`${e.kind}:${e.name}`,n]))}async load(){this.numbers=Hn.get("marks")??await Fo("marks",Float32Array)}add(t,e){let n=this.times.length*e.length;if(n+e.length>this.numbers.length){let s=new Float32Array(2*(n+e.length));s.set(this.numbers.subarray(0,n)),this.numbers=s}this.numbers.set(e,n),this.times.push(t)}moment(t,e){let n=er(this.times,t),s=e?Math.min(n+1,this.times.length-1):n,r=this.times[s]-this.times[n];return{k:n,next:s,mix:r>0?Math.min(1,Math.max(0,(t-this.times[n])/r)):0}}vector(t,e,{k:n,next:s,mix:r}){let o=td*this.list.length,a=n*o+td*t+3*e,l=s*o+td*t+3*e,c=this.numbers;return[c[a]+r*(c[l]-c[a]),c[a+1]+r*(c[l+1]-c[a+1]),c[a+2]+r*(c[l+2]-c[a+2])]}way(t){return this.times.map((e,n)=>this.vector(t,0,{k:n,next:n,mix:0}))}index(t,e){return this.byName.get(`${t}:${e}`)??-1}};var Mh=30,c1=160,h1=200,u1=6.3,g0=12,_0=["joint","drive","strut","spring","force","body"],bh=class{constructor(t,e){this.stage=e,this.corner=document.createElement("div"),this.corner.className="corner",this.labels=document.createElement("div"),this.labels.className="names",t.append(this.labels,this.corner),this.named=!1,this.told=-1/0}end(){this.labels.remove(),this.corner.remove()}show(){this.showCorner(),this.showNames()}showCorner(){let{camera:t,run:e}=this.stage,n=t.matrixWorldInverse.elements,s=h=>[n[0]*h[0]+n[4]*h[1]+n[8]*h[2],-(n[1]*h[0]+n[5]*h[1]+n[9]*h[2])],r=[["x",[1,0,0],"#b3261e",Mh],["y",[0,1,0],"#1f7a3d",Mh],["z",[0,0,1],"#1d5fae",Mh]],o=e.gravity??[0,0,0],a=Math.sqrt(ei(o,o));a>0&&r.push([`g ${Kn(a,3)} m/s\xB2`,o.map(h=>h/a),as().ink,1.3*Mh]);let l=performance.now();if(this.stage.playing&&this.stage.inSoftware&&l-this.told<c1)return;let c=r.map(([,h])=>s(h).map(u=>u.toFixed(3))).join();c!==this.cornerShown&&(this.cornerShown=c,this.told=l,this.corner.innerHTML=`<svg viewBox="-60 -60 120 120">${r.map(([h,u,f,d])=>{let[g,x]=s(u).map(E=>E*d),m=Math.hypot(g,x)||1,p=Math.min(7,.5*m),v=g/m,A=x/m,M=g-v*p,C=x-A*p,S=.45*p,_=[[g,x],[M-A*S,C+v*S],[M+A*S,C-v*S]].map(E=>E.map(U=>U.toFixed(2)).join()).join(" ");return`<line x1="0" y1="0" x2="${M}" y2="${C}" stroke="${f}" stroke-width="2"/><polygon points="${_}" fill="${f}"/><text x="${g+8*v}" y="${x+9*A+4}" fill="${f}" text-anchor="middle">${h}</text>`}).join("")}</svg>`)}showNames(){let{stage:t}=this;if(this.labels.hidden=!this.named||!t.symbols,this.labels.hidden)return;let{clientWidth:e,clientHeight:n}=t.place,s=new W,r=t.symbols.names(t.time,t.smooth).sort((a,l)=>_0.indexOf(a.kind)-_0.indexOf(l.kind)).slice(0,h1),o=[];for(;this.labels.childElementCount>r.length;)this.labels.lastChild.remove();r.forEach(({text:a,kind:l,place:c},h)=>{let u=this.labels.children[h]??this.labels.appendChild(document.createElement("span"));s.set(...c).project(t.camera),u.textContent=a,u.className=l;let f=(s.x+1)*e/2+6,d=(1-s.y)*n/2,g=f+u1*a.length,x=s.z<=1&&!o.some(m=>f<m.right&&m.x<g&&Math.abs(d-m.y)<g0);u.hidden=!x,x&&o.push({x:f,y:d,right:g}),u.style.transform=`translate(${f}px,${d-.5*g0}px)`})}};var Me={joint:"#1f4e79",axis:"#5b8db8",bracket:"#8b95a1",ground:"#6b6257",strut:"#5a6673",gas:"#56b4e9",mr:"#8e5bd0",honeycomb:"#d6a419",spring:"#e08a1e",table:"#5a6673",stops:"#5a6673",drive:"#c2006b",gear:"#00857c",force:"#d1272b",cable:"#2b2b2b",track:"#d55e00",mass:"#333f4c"},f1=.009,d1=5,ed=[{name:"struts",text:"struts, springs, cables",kinds:["strut","spring","cable"],on:!0},{name:"joints",text:"joints",kinds:["joint"],on:!0},{name:"drives",text:"drives, gears",kinds:["drive","gear"],on:!0},{name:"forces",text:"given forces",kinds:["force"],on:!0},{name:"brackets",text:"brackets to bodies",kinds:[],on:!0}],Sh=class{constructor(t,e,n,s,r,o,a){Object.assign(this,{marks:t,bodies:e,up:r,solids:o,tracks:a}),this.u=f1*s,this.object={visible:!0},this.on=Object.fromEntries(ed.map(({name:c,on:h})=>[c,h])),this.layerOf=Object.fromEntries(ed.flatMap(({name:c,kinds:h})=>h.map(u=>[u,c]))),this.bodyNumber=new Map(n.map((c,h)=>[c,h]));let l={k:0,next:0,mix:0};this.lengths=t.list.map((c,h)=>ni(Ks(t.vector(h,1,l),t.vector(h,0,l)))),this.largest={force:this.largestOf("force",2),torque:this.largestOf("force",3),drive:this.largestOf("drive",2)},this.findBrackets(l)}layers(){let t=new Set(this.marks.list.map(e=>e.kind));return ed.filter(e=>e.name==="brackets"?this.brackets.length>0:e.kinds.some(n=>t.has(n)))}largestOf(t,e){let n=0;return this.marks.list.forEach((s,r)=>{if(s.kind===t)for(let o=0;o<this.marks.times.length;++o)n=Math.max(n,ni(this.marks.vector(r,e,{k:o,next:o,mix:0})))}),n}grow(){let t=this.marks.times.length-1,e={k:t,next:t,mix:0};this.marks.list.forEach((n,s)=>{let r=(o,a)=>this.largest[o]=Math.max(this.largest[o],ni(this.marks.vector(s,a,e)));n.kind==="force"&&(r("force",2),r("torque",3)),n.kind==="drive"&&r("drive",2)}),this.track&&this.setTrack(this.track)}findBrackets(t){this.brackets=[];let e=new Set;this.marks.list.forEach((n,s)=>{n.kind==="body"||n.kind==="gear"||n.kind==="drive"||n.bodies.forEach((r,o)=>{let a=this.marks.vector(s,o,t),l=`${r} ${a.map(u=>Math.round(u/(.1*this.u)))}`;if(e.has(l))return;if(e.add(l),r==="ground"){this.brackets.push({mark:s,end:o,ground:!0});return}let c=this.bodies?.nearest(this.bodyNumber.get(r),a);if(c){c.gap>.3*this.u&&this.brackets.push({mark:s,end:o,near:c});return}let h=this.marks.index("body",r);h>=0&&ni(Ks(a,this.marks.vector(h,0,t)))>.3*this.u&&this.brackets.push({mark:s,end:o,centre:h})})}),this.hidden=this.marks.list.flatMap((n,s)=>n.kind==="body"&&!this.bodies?.has(this.bodyNumber.get(n.name))?[s]:[])}show(t,e){let{solids:n,marks:s,u:r}=this,o=s.moment(t,e);if(n.begin(),this.object.visible){for(let a of this.hidden)n.ball(s.vector(a,0,o),1.5*r,Me.mass);if(this.on.brackets)for(let a of this.brackets)this.bracket(a,o);s.list.forEach((a,l)=>{this.on[this.layerOf[a.kind]]&&this[a.kind]?.(a,l,[0,1,2,3].map(c=>s.vector(l,c,o)))})}n.finish(),this.showTrack(o,t)}bracket({mark:t,end:e,ground:n,near:s,centre:r},o){let{solids:a,marks:l,u:c}=this,h=l.vector(t,e,o);if(n){let u=ve(h,this.up,-2.4*c);a.cone(u,h,1.3*c,.3*c,Me.ground),a.tube(ve(u,this.up,-.3*c),u,1.9*c,Me.ground)}else a.tube(h,s?this.bodies.place(s):l.vector(r,0,o),.45*c,Me.bracket)}axis(t,e,n=d1){this.solids.tube(ve(t,e,-n*this.u),ve(t,e,n*this.u),.16*this.u,Me.axis)}barrel(t,e,n,s,r=Me.joint){this.solids.tube(ve(t,e,-n*this.u),ve(t,e,n*this.u),s*this.u,r)}joint({type:t},e,[n,s,r,o]){let{solids:a,u:l}=this,c=yr(n,s,.5),h=gn(r),u=gn(o,vr(h)),f={fixed:()=>this.barrel(c,h,.8,1.1),spherical:()=>a.ball(c,1.4*l,Me.joint),universal:()=>{for(let d of[h,u])this.axis(c,d,3.4),this.barrel(c,d,2,.75)},constant_velocity:()=>{a.ball(c,1.2*l,Me.joint);for(let d of[h,u])this.axis(c,d,3.4)},revolute:()=>{this.axis(c,h),this.barrel(c,h,1.8,1.1)},cylindrical:()=>{this.axis(c,h),this.barrel(c,h,2.6,.9)},prismatic:()=>{this.axis(c,h);for(let d of[-1.3,1.3])this.barrel(ve(c,h,d*l),h,.45,1.35)},planar:()=>{this.axis(c,h,3),this.barrel(c,h,.15,3.2)},prescribed:()=>{this.axis(c,h,4),this.barrel(c,h,1.4,1.2,Me.drive)},distance:()=>{for(let d of[n,s])a.ball(d,.9*l,Me.joint);a.tube(n,s,.4*l,Me.joint)},point_on_plane:()=>{let d=ve(s,h,-ei(Ks(s,n),h));a.ball(s,1.1*l,Me.joint),this.barrel(d,h,.15,3.2)},rolling:()=>this.solids.tube(ve(s,u,-.25*l),ve(s,u,.25*l),ni(o),Me.axis),rolling_ball:()=>a.ball(s,1.1*l,Me.joint)};(f[t]??f.fixed)()}strut({type:t},e,[n,s]){let{solids:r,u:o}=this,a=t.split("+"),l=gn(Ks(s,n)),c=this.lengths[e];for(let f of[n,s])r.ball(f,.8*o,Me.strut);r.tube(n,s,.34*o,Me.strut);let h=a.filter(f=>["gas","mr","honeycomb","table"].includes(f));h.length===0&&a.length===1&&a[0]==="stops"&&h.push("stops");let u=Math.min(.34*c,10*o);h.forEach((f,d)=>{let g=.16*c+d*u/h.length,x=g+u/h.length;r.tube(ve(n,l,g),ve(n,l,x),1.25*o,Me[f])}),a.includes("spring")&&this.coil(n,s,h.length>0?1.7:1.1)}coil(t,e,n){let{solids:s,u:r}=this,o=gn(Ks(e,t)),a=vr(o),l=ws(o,a),c=7,h=8,u=[t];for(let f=0;f<=c*h;++f){let d=2*Math.PI*f/h;u.push(ve(ve(yr(t,e,.1+.8*f/(c*h)),a,n*r*Math.cos(d)),l,n*r*Math.sin(d)))}s.line([...u,e],.2*r,Me.spring)}cable(t,e,[n,s]){this.solids.tube(n,s,.22*this.u,Me.cable)}spring({type:t},e,[n,s,r]){let{solids:o,u:a}=this,l=yr(n,s,.5),c=gn(r);if(t==="torsion")for(let h=0;h<3;++h)o.arc(ve(l,c,(h-1)*.7*a),c,(1.9+.15*h)*a,.96,.6*a,Me.spring,!1);if(t==="centring")for(let h of[c,vr(c)])o.arc(l,h,1.9*a,1,.6*a,Me.spring,!1);if(t==="bushing"){for(let h of[-.9,0,.9])this.barrel(ve(l,c,h*a),c,.28,1.7,Me.spring);o.tube(n,s,.3*a,Me.spring)}}drive({type:t},e,[n,s,r,o]){let{solids:a,u:l}=this,c=yr(n,s,.5),h=gn(o),u=ei(r,h),f=this.largest.drive>0?u/this.largest.drive:0,d=u<0?-1:1;if(t==="turns")a.arc(c,h,3*l,d*(.35+.5*Math.abs(f)),.8*l,Me.drive);else{let g=ve(c,vr(h),2*l);a.arrow(ve(g,h,-d*2*l),ve(g,h,d*(2+5*Math.abs(f))*l),1.5*l,Me.drive)}}gear({type:t},e,[n,s,r,o]){let{solids:a,u:l}=this,c=gn(r),h=vr(c),u=ws(c,h),f=o[1]>.5,d=10,g=Ks(s,n),x=Math.max(1,Math.round(ni(g)/(3*l)));for(let m=0;m<x;++m)a.tube(ve(n,g,(m+.25)/x),ve(n,g,(m+.75)/x),.16*l,Me.gear);if(!f){this.barrel(n,c,3.2,.5,Me.gear);return}this.barrel(n,c,.3,2,Me.gear);for(let m=0;m<d;++m){let p=ve([0,0,0].map((v,A)=>h[A]*Math.cos(2*Math.PI*m/d)),u,Math.sin(2*Math.PI*m/d));a.tube(ve(n,p,1.9*l),ve(n,p,2.6*l),.32*l,Me.gear)}}force({type:t},e,[n,,s,r]){let{solids:o,u:a,largest:l}=this,c=ni(s),h=ni(r);if(l.force>0&&c>.001*l.force){let u=gn(s);o.arrow(ve(n,u,-(4+16*(c/l.force))*a),n,1.9*a,Me.force)}l.torque>0&&h>.001*l.torque&&o.arc(n,gn(r),3.4*a,.3+.5*h/l.torque,.8*a,Me.force),l.force===0&&l.torque===0&&o.ball(n,.8*a,Me.force)}setTrack(t){this.track=this.marks.byName.has(t)?t:"",this.way=this.track?this.marks.way(this.marks.byName.get(this.track)):[]}showTrack(t){let{tracks:e,u:n}=this;if(e.begin(),this.track){let s=this.marks.vector(this.marks.byName.get(this.track),0,t);e.line([...this.way.slice(0,t.k+1),s],.34*n,Me.track),e.line([s,...this.way.slice(t.k+1)],.14*n,Me.track),e.ball(s,.9*n,Me.track)}e.finish()}names(t,e){let n=this.marks.moment(t,e);return this.marks.list.flatMap((s,r)=>s.kind==="gear"||s.kind!=="body"&&!this.on[this.layerOf[s.kind]]?[]:[{text:s.name,kind:s.kind,place:yr(this.marks.vector(r,0,n),this.marks.vector(r,1,n),.5)}])}};var p1={x:[1,0,0],y:[0,1,0],z:[0,0,1]},m1=.4,x0=.47,y0=33,g1=1.1,_1=10,x1=3e5,wh=class i{constructor(t,e,n,s){if(this.place=t,this.run=e,this.smooth=!0,this.held=!1,this.time=0,this.controls=null,!(!e.grains&&!e.bodies&&!e.marks&&!e.meshes?.length&&!e.bed)){this.renderer=n??i.newRenderer(),this.renderer.setClearColor(as().stage),this.ratio=Math.min(window.devicePixelRatio||1,2),t.append(this.renderer.domElement),this.inSoftware=this.drawsInSoftware(),this.paints=this.inSoftware&&e.grains?.count<x1,this.scene=new ra,this.camera=new Xn(35,1,.01,1e3),this.up=gn((e.gravity??[0,0,0]).map(r=>-r)),this.camera.up.set(...this.up),this.scene.add(new ga(16777215,1)),e.grains&&(this.grains=new yh(e.grains)),e.bodies&&(this.bodies=new Na(e.bodies,e.bodyNames)),e.other?.bodies&&(this.other=new Na(e.other.bodies,e.other.bodyNames,!0)),e.marks&&(this.marks=new vh(e.marks));for(let r of this.parts())this.scene.add(r.object);this.scenery=s,this.box=new Qn,s&&!s.box.isEmpty()&&this.box.union(s.box),s&&this.scene.add(s.build());for(let r of[e.grains,e.bodies,e.marks,e.other?.bodies])r&&(this.box.expandByPoint(new W(...r.view.low)),this.box.expandByPoint(new W(...r.view.high)));this.size=this.box.getSize(new W).length()||1,this.overlay=new bh(t,this),this.addGround(),this.orbit=new fh(this.camera,this.renderer.domElement),this.orbit.addEventListener("change",()=>this.wish()),this.look(-65,24),this.overlay.show(),this.clip={axis:"",share:.5,flip:!1},this.observer=new ResizeObserver(()=>this.resize()),this.observer.observe(t),this.resize()}}static newRenderer(){let t=document.createElement("canvas"),e=t.getContext("webgl2",{alpha:!1,antialias:!1,powerPreference:"high-performance"});return new rh({canvas:t,context:e})}end(){this.scene&&(this.observer.disconnect(),this.orbit.dispose(),this.overlay.end(),this.scene.traverse(t=>{t.geometry?.dispose(),t.material?.dispose()}),this.scene=null)}drawsInSoftware(){let t=this.renderer.getContext(),e=t.getExtension("WEBGL_debug_renderer_info"),n=t.getParameter(e?e.UNMASKED_RENDERER_WEBGL:t.RENDERER);return/swiftshader|llvmpipe|softpipe|software|basic render/i.test(n)}parts(){return[this.grains,this.bodies,this.other].filter(Boolean)}async loadFirst(){for(let t of this.parts())await t.loadFirst();if(await this.marks?.load(),this.marks){let t=new Qn;for(let e of[this.run.bodies,this.run.marks])if(e)for(let n of["low","high"])t.expandByPoint(new W(...e.view[n]));this.mechanism=t,this.symbols=new Sh(this.marks,this.bodies,this.run.bodyNames,t.getSize(new W).length()||this.size,this.up,new Mr({ghost:.28}),new Mr({above:!0})),this.symbols.object=new Qe().add(this.symbols.solids.object,this.symbols.tracks.object),this.scene.add(this.symbols.object)}this.hasFrames=!0}async loadNext(){let t=!1;for(let e of this.parts())t=await e.loadNext()||t;return t}loaded(){let t=this.parts();return t.length===0?1:Math.min(...t.map(e=>e.frames.length/e.times.length))}addForces(t){this.scene&&(this.arrows=new ph(t,this.run.bodyNames,this.size,this.marks),this.scene.add(this.arrows.object))}addGround(){let t=10**Math.floor(Math.log10(this.size/8));this.square=[1,2,5,10].map(l=>l*t).find(l=>this.size/l<16)??10*t;let e=2*Math.ceil(this.size/this.square/2),n=this.box.getCenter(new W),s=l=>Math.round(l/this.square)*this.square,r=(l=as().lines)=>new _a(e*this.square,e,as().axes,l).rotateX(Math.PI/2),o=this.run.planes??[];if(this.slope=0,this.run.terrain&&this.addTerrain(this.run.terrain),o.forEach(({point:l,normal:c},h)=>{let u=new W(...c),f=r(10721920),d=n.clone().addScaledVector(u,-u.dot(n.clone().sub(new W(...l)))),g=new Yn().setFromUnitVectors(new W(0,0,1),u),x=new Qe().add(f,this.ground(.5*e*this.square,g));x.applyQuaternion(g),x.position.copy(d),this.scene.add(x),h===0&&(this.slope=Math.acos(Math.min(1,Math.abs(ei(gn(c),this.up)))))}),o.length>0||this.run.terrain)return;this.slope=Math.acos(Math.min(1,this.up[2]));let a=r();a.position.set(s(n.x),s(n.y),this.box.min.z),this.scene.add(a)}addTerrain({first:t,step:e,counts:n,heights:s,rocks:r}){let o=gn([-.5,-.6,.9]),[a,l]=n,c=[],h=[],u=[],f=(M,C)=>s[Math.min(l-1,Math.max(0,C))*a+Math.min(a-1,Math.max(0,M))],d=Math.min(...s),g=Math.max(...s),x=[1,2,5,10].map(M=>M*10**Math.floor(Math.log10((g-d||1)/10))).find(M=>(g-d)/M<12),m=(M,C)=>C.map(S=>S*(.45+.55*Math.max(0,ei(M,o))));for(let M=0;M<l;++M)for(let C=0;C<a;++C){c.push(t[0]+C*e[0],t[1]+M*e[1],f(C,M));let S=gn([(f(C-1,M)-f(C+1,M))/(2*e[0]),(f(C,M-1)-f(C,M+1))/(2*e[1]),1]);h.push(...m(S,[.72,.66,.52])),C+1<a&&M+1<l&&u.push(M*a+C,M*a+C+1,(M+1)*a+C+1,M*a+C,(M+1)*a+C+1,(M+1)*a+C)}let p=(M,C,S)=>{let _=new Oe().setIndex(S);_.setAttribute("position",new Ge(M,3)),_.setAttribute("color",new Ge(C,3)),this.scene.add(new tn(_,new Zi({vertexColors:!0,side:Dn,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1})))};p(c,h,u);let v=[];for(let M=0;M<u.length&&g>d;M+=3){let C=[0,1,2].map(_=>c.slice(3*u[M+_],3*u[M+_]+3)),S=C.map(_=>_[2]);for(let _=Math.ceil(Math.min(...S)/x)*x;_<=Math.max(...S);_+=x){let E=[];for(let[U,D]of[[0,1],[1,2],[2,0]])(S[U]-_)*(S[D]-_)<0&&E.push(ve(C[U],C[D].map((L,B)=>L-C[U][B]),(_-S[U])/(S[D]-S[U])));E.length===2&&v.push(...E[0],...E[1])}}let A=new Oe;A.setAttribute("position",new Ge(v,3)),this.scene.add(new ys(A,new Ji({color:9274472})));for(let[M,C,S,_]of r){let E=new da(_,24,16),U=E.getAttribute("position").array,D=[],L=[];for(let B=0;B<U.length;B+=3)D.push(...m([U[B]/_,U[B+1]/_,U[B+2]/_],[.6,.57,.53])),L.push(U[B]+M,U[B+1]+C,U[B+2]+S);p(L,D,[...E.index.array])}}ground(t,e){let n=t,s=new W(...this.up).applyQuaternion(e.clone().invert()).toArray(),r=[[-n,-n,0],[n,-n,0],[n,n,0],[-n,n,0]],o=r.map(u=>ei(u,s)),a=Math.min(...o),l=r.map((u,f)=>ve(u,s,a-o[f])),c=new Qe,h=(u,f)=>{let d=new Oe;d.setAttribute("position",new Ge(u.flat(),3));let g=new tn(d,new Zi({color:f,side:Dn,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}));g.renderOrder=2,c.add(g)};return h([0,1,2,0,2,3].map(u=>r[u]),14274484),Math.max(...o)-a>.001*n&&s[2]>.1&&r.forEach((u,f)=>h([u,r[(f+1)%4],l[(f+1)%4],u,l[(f+1)%4],l[f]],f%2?11905416:12892310)),c}look(t,e,n=1,s=null){if(!this.scene)return;let r=m0(t,e,this.up),o=s?new W(...s):this.box.getCenter(new W),a=Math.tan(this.camera.fov*Math.PI/360)*Math.min(1,this.camera.aspect);this.camera.position.copy(o).addScaledVector(new W(...r),x0*this.size/a/n),this.camera.near=this.size/500/Math.max(1,n),this.camera.far=this.size*20,this.camera.updateProjectionMatrix(),this.orbit.target.copy(o),this.orbit.update(),this.wish()}lookAtMechanism(t,e){let n=this.mechanism??this.box;this.look(t,e,this.size/(n.getSize(new W).length()||this.size),n.getCenter(new W).toArray())}eye(){let t=this.camera.position.clone().sub(this.orbit.target),{x:e,y:n,z:s}=jf(this.up),r=t.toArray(),o=t.length(),a=Math.tan(this.camera.fov*Math.PI/360)*Math.min(1,this.camera.aspect);return{azimuth:Math.atan2(ei(r,n),ei(r,e))*180/Math.PI,elevation:Math.asin(Math.min(1,Math.max(-1,ei(r,s)/o)))*180/Math.PI,zoom:x0*this.size/a/o,at:this.orbit.target.toArray()}}setClip(t){if(!this.scene)return;Object.assign(this.clip,t);let{axis:e,share:n,flip:s}=this.clip,r=s?1:-1,o=(p1[e]??[0,0,0]).map(l=>l*r),a=e?this.box.min[e]+n*(this.box.max[e]-this.box.min[e]):0;this.grains?.material.uniforms.uClip.value.set(...o,e?r*a:1);for(let l of[this.bodies,this.other])l?.uniforms.uClip.value.set(...o,e&&this.clip.bodies?r*a:1e30);this.clipAt=a,this.wish()}setTime(t){this.time=t,this.scene&&(this.grainFrame=this.grains?.show(t,this.smooth),this.bodies?.show(t,this.smooth),this.other?.show(t,this.smooth),this.symbols?.show(t,this.smooth),this.arrows?.show(t,e=>this.bodies?.centre(e)??null,this.smooth),this.wish())}resize(){let{clientWidth:t,clientHeight:e}=this.place;!this.scene||!(t>0&&e>0)||(this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.renderer.setPixelRatio(this.ratio),this.renderer.setSize(t,e),this.grains&&(this.grains.material.uniforms.uPixels.value=this.renderer.domElement.height),this.wish())}suitRate(t,e){if(!this.scene)return!1;let n=Math.min(window.devicePixelRatio||1,2),s=this.ratio;return e?this.playing?t>0&&t<y0&&(s=Math.max(m1,s*Math.max(.7,Math.sqrt(t/y0)))):s=Math.min(n,g1*(this.suited??n)):s=n,this.playing=e,e&&(this.suited=s),s===this.ratio?!1:(this.ratio=s,this.resize(),!0)}facetsOfMechanism(t,e){if(!this.paints||!this.playing||!this.grains.object.visible)return null;let n=this.facets??=new gh;return n.begin(this.camera,t,e),this.bodies?.object.visible&&!this.bodies.collect(n)?null:(this.symbols?.object.visible&&this.symbols.solids.collect(n),n.whole?n:null)}wish(){this.wished||!this.scene||(this.wished=!0,requestAnimationFrame(()=>this.wished&&this.draw()))}draw(){if(this.wished=!1,!this.scene||!this.hasFrames||this.held)return;this.camera.updateMatrixWorld();let{width:t,height:e}=this.renderer.domElement,n=this.facetsOfMechanism(t,e),s=n===null;this.bodies?.showMeshes(s),this.symbols?.solids.showMeshes(s,s&&(!this.playing||!this.inSoftware)),this.grains?.paint(this.paints,this.camera,t,e,n),this.renderer.render(this.scene,this.camera),this.overlay.show()}async drawn(){this.draw();let t=this.renderer?.getContext(),e=t?.fenceSync(t.SYNC_GPU_COMMANDS_COMPLETE,0);if(e){t.flush();do await new Promise(n=>setTimeout(n,_1));while(!t.isContextLost()&&t.getSyncParameter(e,t.SYNC_STATUS)!==t.SIGNALED);t.deleteSync(e)}}};function v0(i){document.body.dataset.state="failed";let t=document.getElementById("footfall-fault");t.hidden=!1,t.textContent=`This run cannot be shown: ${i.message}. The page needs a browser of 2023 or later with WebGL 2.`,console.error(i)}var y1=160,v1=1e3,M1=50,b1=1e4,S1=()=>new Promise(i=>setTimeout(i,0));async function M0(i,t,e,n,{renderer:s,held:r=!1}={}){let o=new AbortController,a=new hh(i);await a.load();let l=new wh(document.getElementById("footfall-stage"),i,s,a);l.held=r,await l.loadFirst(),l.addForces(t);let c=[t.time,i.grains?.times??[],i.bodies?.times??[],i.marks?.times??[],i.other?.history.time??[]].filter(p=>p.length>0),h=new qa({start:Math.min(...c.map(p=>p[0])),end:Math.max(...c.map(p=>p[p.length-1])),marks:i.grains?.times??i.bodies?.times??i.marks?.times??t.time}),u=p=>{h.setLive(!1),h.seek(p)},f=i.history?new ll(document.getElementById("footfall-plots"),t,n,u,o.signal,await Ed(i)):null;f&&Nd(document.getElementById("footfall-plots"),i,u);let d=new Wa(i,l,h,o.signal);l.controls=d;let g=-1/0;h.onTime=p=>{l.setTime(p);let v=performance.now();h.playing&&v-g<y1||(g=v,f?.showTime(p),d.showTime(p))},h.onStopped=()=>h.seek(h.time),h.seek(h.start),l.resize(),d.follow(e),window.addEventListener("hashchange",()=>d.follow(Oh()),{signal:o.signal}),l.draw();let x=p=>(h.seek(p),d.showCaption(h.time,window.footfall.slow),l.draw(),h.time),m=()=>{o.abort(),h.play(!1),l.end(),d.end(),document.getElementById("footfall-plots").replaceChildren()};return window.footfall={run:i,history:t,stage:l,player:h,plots:f,controls:d,picture:x,end:m}}async function b0(i){for(let t=!0;t;)t=await i.stage.loadNext(),i.controls.showLoaded(),await S1()}async function w1(){let i=document.createElement("style");i.textContent=Md+bd+Sd,document.head.append(i);let t=wd(),e=Oh();if(document.body.classList.toggle("picture",e.picture==="1"),document.body.classList.toggle("still",!t.history&&!t.live),t.live)return E1(t,e);let n=t.history?await Uh(t):{time:new Float64Array,columns:new Map},s=await M0(t,n,e,t.shown);document.body.dataset.firstFrame=Math.round(performance.now()),document.body.dataset.state="loading",await b0(s),s.player.seek(e.t!==void 0?Number(e.t)||s.player.start:s.player.time),document.body.dataset.loaded=Math.round(performance.now()),document.body.dataset.state="ready",e.picture==="1"&&s.picture(s.player.time)}function E1(i,t){let e=document.createElement("output");e.className="progress",e.textContent="waiting for the first frames of the run",document.querySelector("header").append(e),document.body.dataset.state="waiting";let n=null,s=-1/0,r=!1,o=!1,a=new Xa(i,{async rebuild(l,c,h){let u=n,f=u?{...u.controls.entries(),...u.player.live?{t:void 0}:{}}:t,d=u?u.player.live:t.t===void 0,g=u?.plots?.chosen??h;return u?.end(),n=await M0(l,c,f,g,{renderer:u?.stage.renderer,held:!0}),await b0(n),n.player.follows=!r,n.controls.addLive(),n.player.setLive(d&&!r),r&&n.player.seek(n.player.end),n.stage.held=!1,await n.stage.drawn(),document.body.dataset.state=r?"ready":"live",n.stage},async grown(l){o||=l===!0;let c=performance.now();if(!(!n||!r&&(c<s||document.hidden))){s=1/0;try{o&&n.controls.colourGrains(),o=!1,n.stage.arrows?.grow(),n.controls.tellForces(),n.plots?.grow(),n.player.grow(a.end),Object.assign(document.body.dataset,{end:a.end,rows:a.rows,bodies:a.bodies.length,grains:a.grains.length}),await n.stage.drawn()}finally{s=c+Math.min(b1,Math.max(v1,M1*(performance.now()-c)))}}},told({text:l,over:c,lost:h}){e.textContent=l,e.classList.toggle("lost",h===!0),c&&(r=!0,this.grown(),e.textContent+=". To keep this page, or to see all its frames: footfall view",document.body.dataset.state="ready",n&&(n.player.follows=!1,n.player.setLive(!1),n.controls.addLive()))}});document.addEventListener("visibilitychange",()=>a.grown()),window.footfallLive=a}window.addEventListener("error",i=>v0(i.error??new Error(i.message)));w1().catch(v0);})();
