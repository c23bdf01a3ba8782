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
(()=>{var wu='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var Tu=`.plots{font:13px/1.35 sans-serif;color:#222}
.plots .chooser{position:relative}
.plots input{width:100%;box-sizing:border-box;padding:.4em .6em;font:inherit;border:1px solid #aaa;border-radius:4px}
.plots ul{list-style:none;margin:0;padding:0}
.plots .found{position:absolute;z-index:5;left:0;right:0;max-height:45vh;overflow:auto;background:#fff;border:1px solid #aaa;box-shadow:0 4px 12px #0003}
.plots .found li{padding:.35em .7em;cursor:pointer}
.plots .found li:hover{background:#eef3f8}
.plots .found li.on{font-weight:bold}
.plots .chosen{margin:.4em 0;columns:24em}
.plots .chosen li{display:flex;align-items:center;gap:.4em;break-inside:avoid}
.plots .chosen li span:nth-child(2){flex:1;overflow-wrap:anywhere}
.plots .chosen output{font-variant-numeric:tabular-nums;white-space:nowrap}
.plots .chosen button{border:0;background:none;cursor:pointer;font-size:1.1em;padding:0 .3em;color:#666}
.plots .dot{flex:none;width:.8em;height:.8em;border-radius:50%}
.plots .unit{color:#555;margin:.3em 0 0 .3em}
.plots .now{position:absolute;left:0;top:0;bottom:0;width:0;border-left:1.5px solid #c2006b;pointer-events:none;will-change:transform}
`;var Au=`html,body{margin:0;height:100%;overflow:hidden}
body{font:13px/1.4 sans-serif;color:#222;display:grid;grid-template:auto minmax(0,1fr) auto / minmax(0,1fr) minmax(300px,30vw);grid-template-areas:"head head" "stage plots" "bar bar"}
header{grid-area:head;max-height:18vh;overflow:auto;padding:.5em 1em;border-bottom:1px solid #ccc}
header h1{font-size:1.1em;margin:0;display:inline}
header span{color:#555;margin-left:1em}
.warning{background:#fff0e0;border-left:4px solid #d55e00;padding:.15em .7em;margin:.4em 0 0}
.warning summary{cursor:pointer;overflow:hidden;text-overflow:ellipsis;white-space:nowrap}
.warning p{margin:.3em 0}
#footfall-stage{grid-area:stage;position:relative;overflow:hidden;background:#eef1f4}
#footfall-stage canvas{display:block;width:100%!important;height:100%!important;touch-action:none}
#footfall-plots{grid-area:plots;overflow:auto;padding:.6em;border-left:1px solid #ccc;background:#fff}
#footfall-bar{grid-area:bar;display:flex;align-items:center;gap:.5em;padding:.5em 1em;border-top:1px solid #ccc;background:#fff}
#footfall-bar input{flex:1;min-width:4em}
#footfall-bar button,#footfall-bar select{font:inherit;min-width:2.4em;height:2.4em}
.play{width:3.2em}
.clock{font-variant-numeric:tabular-nums;min-width:6.5em;text-align:right}
#footfall-panel{position:absolute;top:.6em;left:.6em;background:#fffffff0;border:1px solid #ccc;border-radius:4px;padding:.4em .7em;max-width:16em;max-height:calc(100% - 2.4em);overflow:auto}
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
.note{color:#555}
#footfall-loading{position:absolute;bottom:.6em;left:.6em;background:#fffffff0;padding:.2em .6em;border-radius:4px}
#footfall-missing{position:absolute;inset:auto 1em 1em auto;max-width:30em;background:#fffffff0;padding:.5em .8em;border-radius:4px}
#footfall-fault{position:fixed;inset:30% 15% auto;background:#fff0e0;border-left:4px solid #d55e00;padding:1em;z-index:9}
.keys{position:fixed;inset:10% auto auto 50%;transform:translateX(-50%);background:#fff;border:1px solid #888;box-shadow:0 6px 20px #0004;padding:1em 1.4em;z-index:8;max-width:30em}
.keys dl{display:grid;grid-template-columns:auto 1fr;gap:.2em 1em;margin:0}
.keys dt{font-weight:bold}.keys dd{margin:0}
#footfall-panel .layers{margin-left:1.4em}
#footfall-panel .layers label{margin:.15em 0}
#footfall-panel select{max-width:11em}
.views{flex-wrap:wrap}
.corner{position:absolute;right:.4em;top:.4em;width:120px;height:120px;pointer-events:none;font:bold 11px sans-serif}
.names span{position:absolute;left:0;top:0;white-space:nowrap;font-size:11px;color:#1f4e79;text-shadow:0 0 2px #fff,0 0 2px #fff,0 0 2px #fff;pointer-events:none}
.names .body{font-weight:bold;color:#333}.names .strut,.names .spring{color:#7a4b00}.names .drive,.names .force{color:#9c0056}
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
@media (max-width:800px){body{grid-template:auto minmax(0,55fr) minmax(0,45fr) auto / minmax(0,1fr);grid-template-areas:"head" "stage" "plots" "bar"}#footfall-plots{border-left:0;border-top:1px solid #ccc}}
`;function Ru(e){if(Uint8Array.fromBase64)return Uint8Array.fromBase64(e);let t=atob(e),i=new Uint8Array(t.length);for(let r=0;r<i.length;++r)i[r]=t.charCodeAt(r);return i}async function Cu(e){let t=new Blob([e]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(t).arrayBuffer())}var pn=class{constructor(t){this.last=new Uint16Array(t)}next(t){let i=this.last.length;if(t.length!==2*i)throw new Error(`a frame has ${t.length} bytes, expected ${2*i}`);let r=new Uint16Array(i);for(let a=0;a<i;++a){let n=t[a]|t[i+a]<<8;r[a]=this.last[a]+(n>>>1^-(n&1))}return this.last=r,r}};function mn(e,t){let i=e.length/4,r=new Uint8Array(e.length);for(let a=0;a<4;++a)for(let n=0;n<i;++n)r[4*n+a]=e[a*i+n];return new t(r.buffer)}function Pu(){return JSON.parse(document.getElementById("footfall-run").textContent)}var ig=5;async function rg(e){for(;;){let t=document.readyState!=="loading",i=document.getElementById(e);if(t||i?.nextElementSibling)return i;await new Promise(r=>setTimeout(r,ig))}}async function Fa(e){let t=await rg(`footfall-${e}`);if(!t)throw new Error(`the page lacks its part "${e}"; was the file cut off?`);let i=t.textContent;return t.remove(),Cu(Ru(i))}async function Il(e,t){return mn(await Fa(e),t)}async function Lu(e){let{names:t,units:i,rows:r}=e.history,a=await Il("history",Float32Array),n=new Map;return t.forEach((s,o)=>n.set(s,{name:s,unit:i[o],values:a.subarray(o*r,(o+1)*r)})),{time:Float64Array.from(e.history.time),columns:n}}function ka(e,t){let i=0,r=e.length-1;for(;i<r;){let a=i+r+1>>1;e[a]<=t?i=a:r=a-1}return i}function Du(e,t,i){let r=ka(e.time,i);if(r+1>=e.time.length||i<=e.time[r])return t[r];let a=e.time[r+1]-e.time[r],n=a>0?(i-e.time[r])/a:1;return t[r]+n*(t[r+1]-t[r])}var Ul=["#0072b2","#d55e00","#009e73","#cc79a7","#e69f00","#56b4e9","#000000","#999999"],Nu=["#8fa6bd","#c98b5f","#7fb09a","#c79bb5","#d9b668","#93c4dd","#9a9a9a","#b7b08f"];function Iu(e){let t=e.map(r=>r.replace(/\d+/g,"#")),i=[...new Set(t)];return t.map(r=>Nu[i.indexOf(r)%Nu.length])}var pa={sand:{shares:[0,.1,.3,.65,1],stops:[[233,223,199],[214,178,104],[127,174,138],[31,111,168],[46,20,90]]},stress:{shares:[0,.25,.5,.75,1],stops:[[0,34,78],[65,77,107],[124,123,120],[188,175,111],[254,232,56]]}};function Uu(e){return`linear-gradient(to top, ${e.stops.map((t,i)=>`rgb(${t.join(",")}) ${100*e.shares[i]}%`).join(", ")})`}function Ol(e=window.location.hash){let t={};for(let i of e.replace(/^#/,"").split("&")){let[r,...a]=i.split("=");r&&(t[decodeURIComponent(r)]=decodeURIComponent(a.join("=")))}return t}function Ou(e){return`#${Object.entries(e).filter(([,i])=>i!==""&&i!==void 0&&i!==null).map(([i,r])=>`${i}=${encodeURIComponent(r).replace(/%2C/g,",").replace(/%3A/g,":")}`).join("&")}`}var Fl=e=>(e??"").split(",").map(Number).filter(Number.isFinite);var ag=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"\xB5"]],ng=/^(N|J|Pa|W|N m)$/,sg=/^(m|rad|s|m\/s|rad\/s)$/;function kl(e,t){let i=ng.test(e);if(!(t>0)||!(i||sg.test(e)))return{factor:1,unit:e==="-"?"":e};for(let[r,a]of ag)if(t>=r&&(i||r<=1))return{factor:1/r,unit:a+e};return{factor:1e6,unit:`\xB5${e}`}}function zi(e,t=4){if(e===0)return"0";let i=Math.abs(e);return i>=1e5||i<.001?e.toExponential(t-1):String(Number(e.toPrecision(t)))}function $s(e,t){let{factor:i,unit:r}=kl(t,Math.abs(e));return`${zi(e*i)} ${r}`.trim()}var og=[["space","play, pause"],["\u2190 \u2192","one frame back, on"],["Home End","start, end"],["+ \u2212","faster, slower"],["c","clip plane across x, y, z, none"],["[ ]","move the clip plane"],["f","forces of the ground"],["j","symbols of joints, struts, drives, forces"],["n","names"],["l","this moment and camera into the address of the page"],["g","next colour of the grains"],["b","next colour of the bodies"],["s","smooth, or frame by frame"],["1 2 3 4 5","from the front, the side, above, all, the mechanism"],["?","this list"]];function nt(e,t={},...i){let r=document.createElement(e);for(let[a,n]of Object.entries(t))a.startsWith("on")?r.addEventListener(a.slice(2),n):r.setAttribute(a,n);return r.append(...i),r}function hs(e,t,i,r){let a=nt("select",{onchange:()=>r(a.value),"aria-label":e});for(let{value:n,text:s}of t)a.append(nt("option",n===i?{value:n,selected:""}:{value:n},s));return{select:a,row:nt("label",{},nt("span",{},e),a)}}var Ir=class{constructor(t,i,r){Object.assign(this,{run:t,stage:i,player:r}),this.frames=0,this.bar(),i.scene&&this.panel(),this.help(),r.onPlaying=a=>{this.button.textContent=a?"\u275A\u275A":"\u25B6",this.button.setAttribute("aria-label",a?"pause":"play"),i.suitRate(0,a)},document.addEventListener("keydown",a=>this.key(a))}bar(){let{player:t}=this;this.button=nt("button",{onclick:()=>t.play(),"aria-label":"play",class:"play"},"\u25B6"),this.slider=nt("input",{type:"range",min:0,max:1e4,value:0,step:1,"aria-label":"time",oninput:()=>{t.play(!1),t.seek(t.start+this.slider.value/1e4*(t.end-t.start))}}),this.clock=nt("output",{class:"clock"});let i=[.05,.1,.25,.5,1,2,4].map(a=>({value:String(a),text:`\xD7 ${a}`})),r=hs("speed",i,"1",a=>t.speed=Number(a));this.speed=r.select,document.getElementById("footfall-bar").append(this.button,nt("button",{onclick:()=>t.step(-1),"aria-label":"one frame back"},"\u2039"),nt("button",{onclick:()=>t.step(1),"aria-label":"one frame on"},"\u203A"),this.slider,this.clock,this.speed,nt("button",{onclick:()=>this.keys.hidden=!this.keys.hidden,"aria-label":"keys"},"?"))}panel(){let{stage:t,run:i}=this,r=[];if(this.legend=nt("div",{class:"legends"}),t.grains){let o=t.grains.colours(),l=hs("grains",o.map(h=>({value:h.name,text:h.name})),o[0].name,()=>this.colourGrains());this.grainColour=l.select,r.push(l.row)}if(t.bodies){let o=[{value:"body",text:"by body"}];i.bodies.stress>0&&o.push({value:"stress",text:"stress"});let l=hs("bodies",o,o[0].value,()=>this.colourBodies());this.bodyColour=l.select,r.push(l.row)}let a=hs("clip",[["","none"],["x","across x"],["y","across y"],["z","across z"]].map(([o,l])=>({value:o,text:l})),"",o=>this.setClip({axis:o}));this.clip=a.select,this.clipPlace=nt("input",{type:"range",min:0,max:1,step:.005,value:.5,"aria-label":"place of the clip plane",oninput:()=>this.setClip({share:Number(this.clipPlace.value)})}),this.clipText=nt("output"),this.clipMore=nt("div",{class:"clip",hidden:""},this.clipPlace,this.clipText,this.check("other side",!1,o=>this.setClip({flip:o})),this.check("bodies too",!1,o=>this.setClip({bodies:o}))),r.push(a.row,this.clipMore),t.arrows?.largest>0&&r.push(this.forces=this.check(`forces of the ground, as their roots, to ${$s(t.arrows.largest,"N")}`,!0,o=>{t.arrows.object.visible=o,t.setTime(t.time)})),t.symbols&&this.symbolRows(r),r.push(this.smooth=this.check("smooth between frames",!0,o=>{t.smooth=o,t.setTime(t.time)}));let n=[["front",-90,4],["side",0,4],["above",-90,89.9],["all",-65,24]];this.views=n.map(([o,l,h])=>nt("button",{onclick:()=>t.look(l,h)},o)),t.mechanism&&this.views.push(nt("button",{onclick:()=>t.lookAtMechanism(-65,18)},"mechanism"));let s=[`grid: squares of ${zi(t.square)} m`];t.slope>.001&&s.push(`slope: ${zi(t.slope*180/Math.PI,3)}\xB0`),t.grains&&s.push(`grains at rest: layers of ${zi(t.grains.layer)} m`),this.notes=s,r.push(nt("div",{class:"views"},...this.views,nt("button",{onclick:()=>this.writeLink(),title:"this moment and camera into the address of the page"},"link")),this.legend,...s.map(o=>nt("div",{class:"note"},o))),document.getElementById("footfall-panel").append(nt("details",innerWidth>700?{open:""}:{},nt("summary",{},"show"),...r)),this.colourGrains(),this.colourBodies()}symbolRows(t){let{stage:i}=this,r=()=>i.setTime(i.time),a=this.symbols=this.check("symbols",!0,o=>{i.symbols.object.visible=o,r()});this.layers=new Map(i.symbols.layers().map(o=>[o.name,this.check(o.text,o.on,l=>{i.symbols.on[o.name]=l,r()})])),this.named=this.check("names",!1,o=>{i.overlay.named=o,i.wish()}),t.push(a,nt("div",{class:"layers"},...this.layers.values(),this.named));let n=i.marks.list.filter(o=>o.kind==="body"||o.kind==="joint").map(o=>`${o.kind}:${o.name}`),s=hs("track of",[{value:"",text:"no point"},...n.map(o=>({value:o,text:o.replace(":"," ")}))],"",o=>{i.symbols.setTrack(o),r()});this.track=s.select,t.push(s.row)}writeLink(){let{stage:t,player:i}=this,r={t:Number(i.time.toPrecision(6))};if(t.scene){let a=t.eye(),n=o=>String(Number(o.toFixed(3)));r.camera=[a.azimuth,a.elevation,a.zoom,...a.at].map(n).join(","),r.grains=this.grainColour?.value,r.bodies=this.bodyColour?.value;let s=[...this.layers??[]].filter(([,o])=>!o.querySelector("input").checked).map(([o])=>o);this.symbols&&!this.symbols.querySelector("input").checked&&s.push("symbols"),this.forces&&!this.forces.querySelector("input").checked&&s.push("arrows"),r.hide=s.join(","),r.track=this.track?.value,r.names=t.overlay.named?"1":"",t.clip.axis&&(r.clip=[t.clip.axis,Number(t.clip.share.toFixed(3))].join(","))}history.replaceState(null,"",Ou(r))}follow(t){let{stage:i,player:r}=this,a=(l,h)=>l&&l.querySelector("input").checked!==h&&Ir.flip(l),n=(l,h)=>{!l||![...l.options].some(c=>c.value===h)||(l.value=h,l.dispatchEvent(new Event("change")))},[s]=Fl(t.t);if(s!==void 0&&r.seek(s),!i.scene)return;let o=Fl(t.camera);if(o.length>=2?i.look(o[0],o[1],o[2]>0?o[2]:1,o.length>=6?o.slice(3,6):null):t.camera==="mechanism"&&i.lookAtMechanism(-65,18),n(this.grainColour,t.grains),n(this.bodyColour,t.bodies),t.track!==void 0&&n(this.track,t.track.includes(":")||t.track===""?t.track:`body:${t.track}`),t.hide!==void 0){let l=t.hide.split(",");for(let[h,c]of this.layers??[])a(c,!l.includes(h));a(this.symbols,!l.includes("symbols")),a(this.forces,!l.includes("arrows")),i.grains&&(i.grains.object.visible=!l.includes("grains")),i.bodies&&(i.bodies.object.visible=!l.includes("bodies"))}if(t.names!==void 0&&a(this.named,t.names==="1"),t.clip!==void 0&&this.clip){let[l,h]=t.clip.split(",");n(this.clip,l),this.setClip({share:Number(h)>=0?Number(h):.5}),this.clipPlace.value=String(i.clip.share)}i.wish()}check(t,i,r){let a=nt("input",{type:"checkbox",...i?{checked:""}:{},onchange:()=>r(a.checked)});return nt("label",{class:"check"},a,nt("span",{},t))}static flip(t){t?.querySelector("input").click()}setClip(t){let{stage:i}=this;i.setClip(t),this.clipMore.hidden=i.clip.axis==="",this.clipText.textContent=i.clip.axis?`${i.clip.axis} = ${zi(i.clipAt,3)} m`:""}colourGrains(){this.stage.grains&&(this.stage.grains.setColour(this.grainColour.value),this.stage.wish(),this.legends())}colourBodies(){this.stage.bodies&&(this.stage.bodies.uniforms.uStress.value=this.bodyColour.value==="stress",this.stage.wish(),this.legends())}legends(){let t=[],i=(a,n,s,o)=>nt("div",{class:"legend"},nt("div",{class:"scale",style:`background:${Uu(n)}`}),nt("div",{class:"ends"},nt("span",{},$s(s,o)),nt("span",{},a),nt("span",{},"0"))),r=this.stage.grains?.colours().find(a=>a.name===this.grainColour.value);r?.largest>0&&t.push(i(`grains, ${r.name}`,pa.sand,r.largest,r.unit)),this.bodyColour?.value==="stress"&&t.push(i("bodies, von Mises",pa.stress,this.run.bodies.stress,"Pa")),this.legend.replaceChildren(...t)}showTime(t){let{player:i,stage:r}=this;this.slider.value=String(Math.round(1e4*(t-i.start)/(i.end-i.start||1))),this.clock.textContent=`${t.toFixed(4)} s`,i.playing&&++this.frames%2===0&&r.suitRate(i.rate(),!0)}showCaption(t,i=0){let{run:r}=this,a=document.getElementById("footfall-caption");if(!a)return;let n=[r.title,r.history?`t = ${t.toFixed(r.digits??3)} s`:"reference configuration",i>1.01?`slowed ${zi(i,3)} times`:i>0&&i<.99?`${zi(1/i,3)} times as fast`:""],s=this.stage.arrows?.largest>0&&this.stage.arrows.object.visible?[`forces of the ground, as their roots, to ${$s(this.stage.arrows.largest,"N")}`]:[];a.replaceChildren(nt("div",{},n.filter(Boolean).join("   ")),...[...this.notes??[],...s].map(o=>nt("div",{class:"note"},o))),this.legend&&this.legend.parentElement!==a.parentElement&&a.parentElement.append(this.legend)}showLoaded(){let t=this.stage.loaded();this.slider.style.setProperty("--loaded",`${100*t}%`),document.getElementById("footfall-loading").hidden=t>=1,document.getElementById("footfall-loading").textContent=`reading frames: ${Math.round(100*t)} %`}help(){let t=nt("dl",{},...og.flatMap(([r,a])=>[nt("dt",{},r),nt("dd",{},a)])),i="One finger or the left button turns, two fingers or the right button move, a pinch or the wheel zooms. A click into a plot goes to that time; a drag zooms it, a double click goes back.";this.keys=nt("div",{class:"keys",hidden:"",onclick:()=>this.keys.hidden=!0},t,nt("p",{},i)),document.body.append(this.keys)}key(t){if(t.ctrlKey||t.metaKey||t.altKey||/^(input|select|textarea)$/i.test(t.target.tagName)&&t.target.type!=="range"&&t.target.type!=="checkbox")return;let{player:i,stage:r}=this,a=(h,c)=>{h&&(h.selectedIndex=(h.selectedIndex+1)%h.options.length,c())},n=h=>{this.speed.selectedIndex=Math.min(this.speed.options.length-1,Math.max(0,this.speed.selectedIndex+h)),i.speed=Number(this.speed.value)},s=h=>{this.clip&&(this.clipPlace.value=String(Number(this.clipPlace.value)+h),this.setClip({share:Number(this.clipPlace.value)}))},l={" ":()=>i.play(),ArrowLeft:()=>i.step(-1),ArrowRight:()=>i.step(1),Home:()=>i.seek(i.start),End:()=>i.seek(i.end),"+":()=>n(1),"=":()=>n(1),"-":()=>n(-1),c:()=>a(this.clip,()=>this.setClip({axis:this.clip.value})),"[":()=>s(-.02),"]":()=>s(.02),f:()=>Ir.flip(this.forces),g:()=>a(this.grainColour,()=>this.colourGrains()),b:()=>a(this.bodyColour,()=>this.colourBodies()),s:()=>Ir.flip(this.smooth),1:()=>this.views?.[0].click(),2:()=>this.views?.[1].click(),3:()=>this.views?.[2].click(),4:()=>this.views?.[3].click(),5:()=>this.views?.[4]?.click(),j:()=>Ir.flip(this.symbols),n:()=>Ir.flip(this.named),l:()=>this.writeLink(),"?":()=>this.keys.hidden=!this.keys.hidden,Escape:()=>this.keys.hidden=!0}[t.key];l&&(t.preventDefault(),l())}};var Ks=class{constructor({start:t,end:i,marks:r}){Object.assign(this,{start:t,end:i,marks:r}),this.time=t,this.seconds=8,this.speed=1,this.playing=!1,this.onTime=()=>{},this.onPlaying=()=>{},this.onStopped=()=>{},this.drawn=[]}seek(t){this.time=Math.min(this.end,Math.max(this.start,t)),this.onTime(this.time)}step(t){this.play(!1);let i=this.marks,r=1e-9*(this.end-this.start);t>0?this.seek(i.find(a=>a>this.time+r)??this.end):this.seek([...i].reverse().find(a=>a<this.time-r)??this.start)}play(t=!this.playing){t!==this.playing&&(this.playing=t,t&&this.time>=this.end&&this.seek(this.start),this.onPlaying(t),this.last=null,this.drawn=[],t||this.onStopped(),t&&requestAnimationFrame(i=>this.tick(i)))}tick(t){if(this.playing){if(this.last!==null){let i=(this.end-this.start)/this.seconds*this.speed,r=this.time+i*(t-this.last)/1e3;if(this.seek(r),r>=this.end)return this.play(!1);this.drawn.push(t),this.drawn.length>30&&this.drawn.shift()}this.last=t,requestAnimationFrame(i=>this.tick(i))}}rate(){let t=this.drawn.length;return t>1?1e3*(t-1)/(this.drawn[t-1]-this.drawn[0]):0}};function _r(e,t,i,r){let a;i=i||0,r=r||t.length-1;let n=r<=2147483647;for(;r-i>1;)a=n?i+r>>1:Ci((i+r)/2),t[a]<e?i=a:r=a;return e-t[i]<=t[r]-e?i:r}function Ed(e){return(i,r,a)=>{let n=-1,s=-1;for(let o=r;o<=a;o++)if(e(i[o])){n=o;break}for(let o=a;o>=r;o--)if(e(i[o])){s=o;break}return[n,s]}}var bd=e=>e!=null,wd=e=>e!=null&&e>0,no=Ed(bd),lg=Ed(wd);function hg(e,t,i,r=0,a=!1){let n=a?lg:no,s=a?wd:bd;[t,i]=n(e,t,i);let o=e[t],l=e[t];if(t>-1)if(r==1)o=e[t],l=e[i];else if(r==-1)o=e[i],l=e[t];else for(let h=t;h<=i;h++){let c=e[h];s(c)&&(c<o?o=c:c>l&&(l=c))}return[o??It,l??-It]}function so(e,t,i,r){i==2&&(r=!0);let a=Bu(e),n=Bu(t);e==t&&(a==-1?(e*=i,t/=i):(e/=i,t*=i));let s=i==10?$r:Td,o=a==1?Ci:Ji,l=n==1?Ji:Ci,h=s(hi(e)),c=s(hi(t)),d=o(h),u=l(c),f=ga(i,d),_=ga(i,u);return i==10&&(d<0&&(f=Kt(f,-d)),u<0&&(_=Kt(_,-u))),r?(e=f*a,t=_*n):(e=Pd(e,ga(i,Ci(h)),!1),t=oo(t,ga(i,Ci(c)),!1)),[e,t]}function ah(e,t,i,r){let a=so(e,t,i,r);return e==0&&(a[0]=0),t==0&&(a[1]=0),a}var nh=.1,Fu={mode:3,pad:nh},gs={pad:0,soft:null,mode:0},cg={min:gs,max:gs};function io(e,t,i,r){return lo(i)?ku(e,t,i):(gs.pad=i,gs.soft=r?0:null,gs.mode=r?3:0,ku(e,t,cg))}function Ct(e,t){return e??t}function ug(e,t,i){for(t=Ct(t,0),i=Ct(i,e.length-1);t<=i;){if(e[t]!=null)return!0;t++}return!1}function ku(e,t,i){let r=i.min,a=i.max,n=Ct(r.pad,0),s=Ct(a.pad,0),o=Ct(r.hard,-It),l=Ct(a.hard,It),h=Ct(r.soft,It),c=Ct(a.soft,-It),d=Ct(r.mode,0),u=Ct(a.mode,0),f=t-e,_=$r(f),x=Fi(hi(e),hi(t)),p=$r(x),m=hi(p-_);(f<1e-24||m>10)&&(f=0,(e==0||t==0)&&(f=1e-24,d==2&&h!=It&&(n=0),u==2&&c!=-It&&(s=0)));let w=f||x||1e3,R=$r(w),E=ga(10,Ci(R)),T=w*(f==0?e==0?.1:1:n),P=Kt(Pd(e-T,E/10),24),v=e>=h&&(d==1||d==3&&P<=h||d==2&&P>=h)?h:It,b=Fi(o,P<v&&e>=v?v:vr(v,P)),U=w*(f==0?t==0?.1:1:s),W=Kt(oo(t+U,E/10),24),N=t<=c&&(u==1||u==3&&W>=c||u==2&&W<=c)?c:-It,B=vr(l,W>N&&t<=N?N:Fi(N,W));return b==B&&b==0&&(B=100),[b,B]}var dg=new Intl.NumberFormat,sh=e=>dg.format(e),Zi=Math,eo=Zi.PI,hi=Zi.abs,Ci=Zi.floor,Mi=Zi.round,Ji=Zi.ceil,vr=Zi.min,Fi=Zi.max,ga=Zi.pow,Bu=Zi.sign,$r=Zi.log10,Td=Zi.log2,fg=(e,t=1)=>Zi.sinh(e)*t,Bl=(e,t=1)=>Zi.asinh(e/t),It=1/0;function zu(e){return($r((e^e>>31)-(e>>31))|0)+1}function Yl(e,t,i){return vr(Fi(e,t),i)}function Ad(e){return typeof e=="function"}function ut(e){return Ad(e)?e:()=>e}var pg=()=>{},Rd=e=>e,Cd=(e,t)=>t,mg=e=>null,Hu=e=>!0,Gu=(e,t)=>e==t,gg=/\.\d*?(?=9{6,}|0{6,})/gm,Va=e=>{if(Dd(e)||va.has(e))return e;let t=`${e}`,i=t.match(gg);if(i==null)return e;let r=i[0].length-1;if(t.indexOf("e-")!=-1){let[a,n]=t.split("e");return+`${Va(a)}e${n}`}return Kt(e,r)};function Ba(e,t,i=!0){return i?Va(Kt(Va(e/t))*t):Kt(e/t)*t}function oo(e,t,i=!0){return i?Va(Ji(Va(e/t))*t):Ji(e/t)*t}function Pd(e,t,i=!0){return i?Va(Ci(Va(e/t))*t):Ci(e/t)*t}function Kt(e,t=0){if(Dd(e))return e;let i=10**t,r=e*i*(1+Number.EPSILON);return Mi(r)/i}var va=new Map;function Ld(e){return((""+e).split(".")[1]||"").length}function vs(e,t,i,r){let a=[],n=r.map(Ld);for(let s=t;s<i;s++){let o=hi(s),l=Kt(ga(e,s),o);for(let h=0;h<r.length;h++){let c=e==10?+`${r[h]}e${s}`:r[h]*l,d=(s>=0?0:o)+(s>=n[h]?0:n[h]),u=e==10?c:Kt(c,d);a.push(u),va.set(u,d)}}return a}var _s={},oh=[],xn=[null,null],ma=Array.isArray,Dd=Number.isInteger,_g=e=>e===void 0;function Vu(e){return typeof e=="string"}function lo(e){let t=!1;if(e!=null){let i=e.constructor;t=i==null||i==Object}return t}function vg(e){return e!=null&&typeof e=="object"}var xg=Object.getPrototypeOf(Uint8Array),Nd="__proto__";function Mn(e,t=lo){let i;if(ma(e)){let r=e.find(a=>a!=null);if(ma(r)||t(r)){i=Array(e.length);for(let a=0;a<e.length;a++)i[a]=Mn(e[a],t)}else i=e.slice()}else if(e instanceof xg)i=e.slice();else if(t(e)){i={};for(let r in e)r!=Nd&&(i[r]=Mn(e[r],t))}else i=e;return i}function ni(e){let t=arguments;for(let i=1;i<t.length;i++){let r=t[i];for(let a in r)a!=Nd&&(lo(e[a])?ni(e[a],Mn(r[a])):e[a]=Mn(r[a]))}return e}var Mg=0,Sg=1,yg=2;function Eg(e,t,i){for(let r=0,a,n=-1;r<t.length;r++){let s=t[r];if(s>n){for(a=s-1;a>=0&&e[a]==null;)e[a--]=null;for(a=s+1;a<i&&e[a]==null;)e[n=a++]=null}}}function bg(e,t){if(Ag(e)){let s=e[0].slice();for(let o=1;o<e.length;o++)s.push(...e[o].slice(1));return Rg(s[0])||(s=Tg(s)),s}let i=new Set;for(let s=0;s<e.length;s++){let l=e[s][0],h=l.length;for(let c=0;c<h;c++)i.add(l[c])}let r=[Array.from(i).sort((s,o)=>s-o)],a=r[0].length,n=new Map;for(let s=0;s<a;s++)n.set(r[0][s],s);for(let s=0;s<e.length;s++){let o=e[s],l=o[0];for(let h=1;h<o.length;h++){let c=o[h],d=Array(a).fill(void 0),u=t?t[s][h]:Sg,f=[];for(let _=0;_<c.length;_++){let x=c[_],p=n.get(l[_]);x===null?u!=Mg&&(d[p]=x,u==yg&&f.push(p)):d[p]=x}Eg(d,f,a),r.push(d)}}return r}var wg=typeof queueMicrotask>"u"?e=>Promise.resolve().then(e):queueMicrotask;function Tg(e){let t=e[0],i=t.length,r=Array(i);for(let n=0;n<r.length;n++)r[n]=n;r.sort((n,s)=>t[n]-t[s]);let a=[];for(let n=0;n<e.length;n++){let s=e[n],o=Array(i);for(let l=0;l<i;l++)o[l]=s[r[l]];a.push(o)}return a}function Ag(e){let t=e[0][0],i=t.length;for(let r=1;r<e.length;r++){let a=e[r][0];if(a.length!=i)return!1;if(a!=t){for(let n=0;n<i;n++)if(a[n]!=t[n])return!1}}return!0}function Rg(e,t=100){let i=e.length;if(i<=1)return!0;let r=0,a=i-1;for(;r<=a&&e[r]==null;)r++;for(;a>=r&&e[a]==null;)a--;if(a<=r)return!0;let n=Fi(1,Ci((a-r+1)/t));for(let s=e[r],o=r+n;o<=a;o+=n){let l=e[o];if(l!=null){if(l<=s)return!1;s=l}}return!0}var fs="width",ps="height",cs="top",Wu="bottom",gn="left",zl="right",lh="#000",ju=lh+"0",Hl="mousemove",Xu="mousedown",Gl="mouseup",Yu="mouseenter",qu="mouseleave",$u="dblclick",Cg="resize",Pg="scroll",Ku="change",ro="dppxchange",hh="--",ci="u-",Lg="uplot",Dg=ci+"hz",Ng=ci+"vt",Ig=ci+"title",Ug=ci+"wrap",Og=ci+"under",Fg=ci+"over",kg=ci+"axis",Ha=ci+"off",Bg=ci+"select",zg=ci+"cursor-x",Hg=ci+"cursor-y",Gg=ci+"cursor-pt",Vg=ci+"legend",Wg=ci+"live",jg=ci+"inline",Xg=ci+"series",Yg=ci+"marker",Ju=ci+"label",qg=ci+"value",ho=typeof window<"u",ql=ho?document:null,vn=ho?window:null,_a,Js;function $l(){let e=devicePixelRatio;_a!=e&&(_a=e,Js&&Jl(Ku,Js,$l),Js=matchMedia(`(min-resolution: ${_a-.001}dppx) and (max-resolution: ${_a+.001}dppx)`),Ga(Ku,Js,$l),vn.dispatchEvent(new CustomEvent(ro)))}function Ki(e,t){if(t!=null){let i=e.classList;!i.contains(t)&&i.add(t)}}function Kl(e,t){let i=e.classList;i.contains(t)&&i.remove(t)}function Vt(e,t,i){e.style[t]=i+"px"}function gr(e,t,i,r){let a=ql.createElement(e);return t!=null&&Ki(a,t),i?.insertBefore(a,r),a}function nr(e,t){return gr("div",e,t)}var Zu=new WeakMap;function Ur(e,t,i,r,a){let n="translate("+t+"px,"+i+"px)",s=Zu.get(e);n!=s&&(e.style.transform=n,Zu.set(e,n),t<0||i<0||t>r||i>a?Ki(e,Ha):Kl(e,Ha))}var Qu=new WeakMap;function ed(e,t,i){let r=t+i,a=Qu.get(e);r!=a&&(Qu.set(e,r),e.style.background=t,e.style.borderColor=i)}var td=new WeakMap;function id(e,t,i,r){let a=t+""+i,n=td.get(e);a!=n&&(td.set(e,a),e.style.height=i+"px",e.style.width=t+"px",e.style.marginLeft=r?-t/2+"px":0,e.style.marginTop=r?-i/2+"px":0)}var ch={passive:!0},$g={...ch,capture:!0};function Ga(e,t,i,r){t.addEventListener(e,i,r?$g:ch)}function Jl(e,t,i,r){t.removeEventListener(e,i,ch)}ho&&$l();var Id=["January","February","March","April","May","June","July","August","September","October","November","December"],Ud=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Od(e){return e.slice(0,3)}var Kg=Ud.map(Od),Jg=Id.map(Od),Zg={MMMM:Id,MMM:Jg,WWWW:Ud,WWW:Kg};function us(e){return(e<10?"0":"")+e}function Qg(e){return(e<10?"00":e<100?"0":"")+e}var e0={YYYY:e=>e.getFullYear(),YY:e=>(e.getFullYear()+"").slice(2),MMMM:(e,t)=>t.MMMM[e.getMonth()],MMM:(e,t)=>t.MMM[e.getMonth()],MM:e=>us(e.getMonth()+1),M:e=>e.getMonth()+1,DD:e=>us(e.getDate()),D:e=>e.getDate(),WWWW:(e,t)=>t.WWWW[e.getDay()],WWW:(e,t)=>t.WWW[e.getDay()],HH:e=>us(e.getHours()),H:e=>e.getHours(),h:e=>{let t=e.getHours();return t==0?12:t>12?t-12:t},AA:e=>e.getHours()>=12?"PM":"AM",aa:e=>e.getHours()>=12?"pm":"am",a:e=>e.getHours()>=12?"p":"a",mm:e=>us(e.getMinutes()),m:e=>e.getMinutes(),ss:e=>us(e.getSeconds()),s:e=>e.getSeconds(),fff:e=>Qg(e.getMilliseconds())};function uh(e,t){t=t||Zg;let i=[],r=/\{([a-z]+)\}|[^{]+/gi,a;for(;a=r.exec(e);)i.push(a[0][0]=="{"?e0[a[1]]:a[0]);return n=>{let s="";for(let o=0;o<i.length;o++)s+=typeof i[o]=="string"?i[o]:i[o](n,t);return s}}var t0=new Intl.DateTimeFormat().resolvedOptions().timeZone;function i0(e,t){if(t==null||t==t0)return typeof e=="number"?new Date(e):e;let i=new Wa(e);return i.setTimeZone(t),i}var ds="2-digit",r0={weekday:"short",year:"numeric",month:ds,day:ds,hour:ds,minute:ds,second:ds,fractionalSecondDigits:3,timeZoneName:"longOffset"},Vl={};function a0(e){return Vl[e]==null&&(Vl[e]=new Intl.DateTimeFormat("sv",{...r0,timeZone:e}).format),Vl[e]}var Wa=class extends Date{tz=null;#t=!1;#i=null;constructor(...t){super(...t),t[0]instanceof Wa&&(this.tz=t[0].tz,this.#i=t[0].#i,this.#t=t[0].#t)}#e(t,i,r,a,n=0){let s=this.#i;return this.#t?t.call(this):s==null?i.call(this):Number(s.slice(r,a))+n}setTimeZone(t){if(this.tz=t,t=="UTC"||t=="Etc/UTC")this.#t=!0;else{let r=a0(t)(this);r.endsWith("GMT")&&(r+="+00:00"),this.#i=r}}getFullYear(){return this.#e(this.getUTCFullYear,super.getFullYear,-33,-29)}getMonth(){return this.#e(this.getUTCMonth,super.getMonth,-28,-26,-1)}getDate(){return this.#e(this.getUTCDate,super.getDate,-25,-23)}getHours(){return this.#e(this.getUTCHours,super.getHours,-22,-20)}getMinutes(){return this.#e(this.getUTCMinutes,super.getMinutes,-19,-17)}getSeconds(){return this.#e(this.getUTCSeconds,super.getSeconds,-16,-14)}getMilliseconds(){return this.#e(this.getUTCMilliseconds,super.getMilliseconds,-13,-10)}getDay(){let t=this.#i;return this.#t?this.getUTCDay():t==null?super.getDay():t[0]=="s"?0:t[0]=="m"?1:t[1]=="i"?2:t[0]=="o"?3:t[1]=="o"?4:t[0]=="f"?5:t[0]=="l"?6:-1}getTimezoneOffset(){let t=this.#i;return this.#t?0:t==null?super.getTimezoneOffset():(60*Number(t.slice(-5,-3))+Number(t.slice(-2)))*(t.at(-6)=="-"?-1:1)}};function n0(e){let t=e.getFullYear(),i=e.getMonth()+1,r=e.getDate();return--i*31-(i>1?(1054267675>>i*3-6&7)-(t&3||!(t%25)&&t&15?0:1):0)+r}var s0=3,to=4,Zl=5;function Wl(e,t){let r=e.getTime()-(e.getMilliseconds()+e.getSeconds()*1e3+e.getMinutes()*60*1e3+e.getHours()*3600*1e3+(t==to?e.getDate()-1:t==Zl?n0(e)-1:0)*24*3600*1e3),a=new Wa(r);a.setTimeZone(e.tz);let n=a.getHours();if(n>0){let s=n>12?24-n:-n;a=new Wa(r+s*3600*1e3),a.setTimeZone(e.tz)}return a}var Fd=e=>e%1==0,ao=[1,2,2.5,5],o0=vs(10,-32,0,ao),kd=vs(10,0,32,ao),l0=kd.filter(Fd),za=o0.concat(kd),dh=`
`,Bd="{YYYY}",rd=dh+Bd,zd="{M}/{D}",ms=dh+zd,Zs=ms+"/{YY}",Hd="{aa}",h0="{h}:{mm}",_n=h0+Hd,ad=dh+_n,nd=":{ss}",At=null;function Gd(e){let t=e*1e3,i=t*60,r=i*60,a=r*24,n=a*30,s=a*365,l=(e==1?vs(10,0,3,ao).filter(Fd):vs(10,-3,0,ao)).concat([t,t*5,t*10,t*15,t*30,i,i*5,i*10,i*15,i*30,r,r*2,r*3,r*4,r*6,r*8,r*12,a,a*2,a*3,a*4,a*5,a*6,a*7,a*8,a*9,a*10,a*15,n,n*2,n*3,n*4,n*6,s,s*2,s*5,s*10,s*25,s*50,s*100]),h=[[s,Bd,At,At,At,At,At,At,1],[a*28,"{MMM}",rd,At,At,At,At,At,1],[a,zd,rd,At,At,At,At,At,1],[r,"{h}"+Hd,Zs,At,ms,At,At,At,1],[i,_n,Zs,At,ms,At,At,At,1],[t,nd,Zs+" "+_n,At,ms+" "+_n,At,ad,At,1],[e,nd+".{fff}",Zs+" "+_n,At,ms+" "+_n,At,ad,At,1]];function c(d){return(u,f,_,x,p,m)=>{let w=[],R=p>=s,E=p>=n&&p<s,T=p>=a&&p<n,P=p>r&&p<a,v=d(_),b=Kt(v*e,3),U=Wl(v,R||E?Zl:T?to:s0),W=Kt(U*e,3);if(T){let N=p/a,B=Ci((v.getDate()-1)/N),I=W+p*B;do{let L=d(I),G=L.getHours();if(G!=0&&(I+=G>12?r:-r,L=d(I)),(L.getDate()-1)%N>0&&(L=Wl(L,to),I=L.getTime()*e,I-w[w.length-1]<p*.7&&w.pop()),I>x)break;I>=_&&w.push(I),I+=p}while(1)}else if(E||R){let N=1,B=1,I=0,L=0;E?(N=p/n,B=32,I=to,L=v.getMonth()):R&&(N=p/s,B=366,I=Zl,L=v.getYear()),p=N*B*a;let G=Ci(L/B),Z=W+p*G;do{if(Z=Wl(d(Z),I).getTime()*e,Z>x)break;Z>=_&&w.push(Z),Z+=p}while(1)}else if(P){let N=p/r,B=Ci(v.getHours()/N),I=W+p*B;do{if(d(I).getHours()%N>0){let Z=d(I-r).getHours();I+=Z%N==0?-r:r}if(I>x)break;I>=_&&w.push(I),I+=p}while(1)}else{let N=W+oo(b-W,p);do{if(N>x)break;N>=_&&w.push(N),N+=p}while(1)}return w}}return[l,h,c]}var[c0,u0,d0]=Gd(1),[f0,p0,m0]=Gd(.001);vs(2,-53,53,[1]);function sd(e,t){return e.map(i=>i.map((r,a)=>a==0||a==8||r==null?r:t(a==1||i[8]==0?r:i[1]+r)))}function od(e,t){return(i,r,a,n,s)=>{let o=t.find(_=>s>=_[0])||t[t.length-1],l,h,c,d,u,f;return r.map(_=>{let x=e(_),p=x.getFullYear(),m=x.getMonth(),w=x.getDate(),R=x.getHours(),E=x.getMinutes(),T=x.getSeconds(),P=p!=l&&o[2]||m!=h&&o[3]||w!=c&&o[4]||R!=d&&o[5]||E!=u&&o[6]||T!=f&&o[7]||o[1];return l=p,h=m,c=w,d=R,u=E,f=T,P(x)})}}function g0(e,t){let i=uh(t);return(r,a,n,s,o)=>a.map(l=>i(e(l)))}function ld(e,t){return t(e)}var _0="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function hd(e,t){return(i,r,a,n)=>n==null?hh:t(e(r))}function v0(e,t){let i=e.series[t];return i.width?i.stroke(e,t):i.points.width?i.points.stroke(e,t):null}function x0(e,t){return e.series[t].fill(e,t)}var M0={show:!0,live:!0,isolate:!1,mount:pg,markers:{show:!0,width:2,stroke:v0,fill:x0,dash:"solid"},idx:null,idxs:null,values:[]};function S0(e,t){let i=e.cursor.points,r=nr(),a=i.size(e,t);Vt(r,fs,a),Vt(r,ps,a);let n=a/-2;Vt(r,"marginLeft",n),Vt(r,"marginTop",n);let s=i.width(e,t,a);return s&&Vt(r,"borderWidth",s),r}function y0(e,t){let i=e.series[t].points;return i._fill||i._stroke}function E0(e,t){let i=e.series[t].points;return i._stroke||i._fill}function b0(e,t){return e.series[t].points.size}var jl=[0,0];function w0(e,t,i){return jl[0]=t,jl[1]=i,jl}function Qs(e,t,i,r=!0){return a=>{a.button==0&&(!r||a.target==t)&&i(a)}}function Xl(e,t,i,r=!0){return a=>{(!r||a.target==t)&&i(a)}}var T0={show:!0,x:!0,y:!0,lock:!1,move:w0,points:{one:!1,show:S0,size:b0,width:0,stroke:E0,fill:y0},bind:{mousedown:Qs,mouseup:Qs,click:Qs,dblclick:Qs,mousemove:Xl,mouseleave:Xl,mouseenter:Xl},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(e,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(e,t,i,r,a)=>r-a,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Vd={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},fh=ni({},Vd,{filter:Cd}),Wd=ni({},fh,{size:10}),jd=ni({},Vd,{show:!1}),ph='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Xd="bold "+ph,Yd=1.5,cd={show:!0,scale:"x",stroke:lh,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Xd,side:2,grid:fh,ticks:Wd,border:jd,font:ph,lineGap:Yd,rotate:0},A0="Value",R0="Time",ud={show:!0,scale:"x",auto:!1,sorted:1,min:It,max:-It,idxs:[]};function C0(e,t,i,r,a){return t.map(n=>n==null?"":sh(n))}function P0(e,t,i,r,a,n,s){let o=[],l=va.get(a)||0;i=s?i:Kt(oo(i,a),l);for(let h=i;h<=r;h=Kt(h+a,l))o.push(Object.is(h,-0)?0:h);return o}function Ql(e,t,i,r,a,n,s){let o=[],l=e.scales[e.axes[t].scale].log,h=l==10?$r:Td,c=Ci(h(i));a=ga(l,c),l==10&&(a=za[_r(a,za)]);let d=a,u=a*l;l==10&&(u=za[_r(u,za)]);do d>=i&&o.push(d),d=d+a,l==10&&!va.has(d)&&(d=Kt(d,va.get(a))),d>=u&&(a=d,u=a*l,l==10&&(u=za[_r(u,za)]));while(d<=r);return o}function L0(e,t,i,r,a,n,s){let l=e.scales[e.axes[t].scale].asinh,h=r>l?Ql(e,t,Fi(l,i),r,a):[l],c=r>=0&&i<=0?[0]:[];return(i<-l?Ql(e,t,Fi(l,-r),-i,a):[l]).reverse().map(u=>-u).concat(c,h)}var qd=/./,D0=/[12357]/,N0=/[125]/,dd=/1/,eh=(e,t,i,r)=>e.map((a,n)=>t==4&&a==0||n%r==0&&i.test(a.toExponential()[a<0?1:0])?a:null);function I0(e,t,i,r,a){let n=e.axes[i],s=n.scale,o=e.scales[s],l=e.valToPos,h=n._space,c=l(10,s),d=l(9,s)-c>=h?qd:l(7,s)-c>=h?D0:l(5,s)-c>=h?N0:dd;if(d==dd){let u=hi(l(1,s)-c);if(u<h)return eh(t.slice().reverse(),o.distr,d,Ji(h/u)).reverse()}return eh(t,o.distr,d,1)}function U0(e,t,i,r,a){let n=e.axes[i],s=n.scale,o=n._space,l=e.valToPos,h=hi(l(1,s)-l(2,s));return h<o?eh(t.slice().reverse(),3,qd,Ji(o/h)).reverse():t}function O0(e,t,i,r){return r==null?hh:t==null?"":sh(t)}var fd={show:!0,scale:"y",stroke:lh,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Xd,side:3,grid:fh,ticks:Wd,border:jd,font:ph,lineGap:Yd,rotate:0};function F0(e,t){let i=3+(e||1)*2;return Kt(i*t,3)}function k0(e,t){let{scale:i,idxs:r}=e.series[0],a=e._data[0],n=e.valToPos(a[r[0]],i,!0),s=e.valToPos(a[r[1]],i,!0),o=hi(s-n),l=e.series[t],h=o/(l.points.space*e.pxRatio);return r[1]-r[0]<=h}var pd={scale:null,auto:!0,sorted:0,min:It,max:-It},$d=(e,t,i,r,a)=>a,md={show:!0,auto:!0,sorted:0,gaps:$d,alpha:1,facets:[ni({},pd,{scale:"x"}),ni({},pd,{scale:"y"})]},gd={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:$d,alpha:1,points:{show:k0,filter:null},values:null,min:It,max:-It,idxs:[],path:null,clip:null};function B0(e,t,i,r,a){return i/10}var Kd={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},z0=ni({},Kd,{time:!1,ori:1}),_d={};function Jd(e,t){let i=_d[e];return i||(i={key:e,plots:[],sub(r){i.plots.push(r)},unsub(r){i.plots=i.plots.filter(a=>a!=r)},pub(r,a,n,s,o,l,h){for(let c=0;c<i.plots.length;c++)i.plots[c]!=a&&i.plots[c].pub(r,a,n,s,o,l,h)}},e!=null&&(_d[e]=i)),i}var Sn=1<<0,th=1<<1;function ja(e,t,i){let r=e.mode,a=e.series[t],n=r==2?e._data[t]:e._data,s=e.scales,o=e.bbox,l=n[0],h=r==2?n[1]:n[t],c=r==2?s[a.facets[0].scale]:s[e.series[0].scale],d=r==2?s[a.facets[1].scale]:s[a.scale],u=o.left,f=o.top,_=o.width,x=o.height,p=e.valToPosH,m=e.valToPosV;return c.ori==0?i(a,l,h,c,d,p,m,u,f,_,x,uo,yn,po,Qd,tf):i(a,l,h,c,d,m,p,f,u,x,_,fo,En,_h,ef,rf)}function mh(e,t){let i=0,r=0,a=Ct(e.bands,oh);for(let n=0;n<a.length;n++){let s=a[n];s.series[0]==t?i=s.dir:s.series[1]==t&&(s.dir==1?r|=1:r|=2)}return[i,r==1?-1:r==2?1:r==3?2:0]}function H0(e,t,i,r,a){let n=e.mode,s=e.series[t],o=n==2?s.facets[1].scale:s.scale,l=e.scales[o];return a==-1?l.min:a==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Kr(e,t,i,r,a,n){return ja(e,t,(s,o,l,h,c,d,u,f,_,x,p)=>{let m=s.pxRound,w=h.dir*(h.ori==0?1:-1),R=h.ori==0?yn:En,E,T;w==1?(E=i,T=r):(E=r,T=i);let P=m(d(o[E],h,x,f)),v=m(u(l[E],c,p,_)),b=m(d(o[T],h,x,f)),U=m(u(n==1?c.max:c.min,c,p,_)),W=new Path2D(a);return R(W,b,U),R(W,P,U),R(W,P,v),W})}function co(e,t,i,r,a,n){let s=null;if(e.length>0){s=new Path2D;let o=t==0?po:_h,l=i;for(let d=0;d<e.length;d++){let u=e[d];if(u[1]>u[0]){let f=u[0]-l;f>0&&o(s,l,r,f,r+n),l=u[1]}}let h=i+a-l,c=10;h>0&&o(s,l,r-c/2,h,r+n+c)}return s}function G0(e,t,i){let r=e[e.length-1];r&&r[0]==t?r[1]=i:e.push([t,i])}function gh(e,t,i,r,a,n,s){let o=[],l=e.length;for(let h=a==1?i:r;h>=i&&h<=r;h+=a)if(t[h]===null){let d=h,u=h;if(a==1)for(;++h<=r&&t[h]===null;)u=h;else for(;--h>=i&&t[h]===null;)u=h;let f=n(e[d]),_=u==d?f:n(e[u]),x=d-a;f=s<=0&&x>=0&&x<l?n(e[x]):f;let m=u+a;_=s>=0&&m>=0&&m<l?n(e[m]):_,_>=f&&o.push([f,_])}return o}function vd(e){return e==0?Rd:e==1?Mi:t=>Ba(t,e)}function Zd(e){let t=e==0?uo:fo,i=e==0?(a,n,s,o,l,h)=>{a.arcTo(n,s,o,l,h)}:(a,n,s,o,l,h)=>{a.arcTo(s,n,l,o,h)},r=e==0?(a,n,s,o,l)=>{a.rect(n,s,o,l)}:(a,n,s,o,l)=>{a.rect(s,n,l,o)};return(a,n,s,o,l,h=0,c=0)=>{h==0&&c==0?r(a,n,s,o,l):(h=vr(h,o/2,l/2),c=vr(c,o/2,l/2),t(a,n+h,s),i(a,n+o,s,n+o,s+l,h),i(a,n+o,s+l,n,s+l,c),i(a,n,s+l,n,s,c),i(a,n,s,n+o,s,h),a.closePath())}}var uo=(e,t,i)=>{e.moveTo(t,i)},fo=(e,t,i)=>{e.moveTo(i,t)},yn=(e,t,i)=>{e.lineTo(t,i)},En=(e,t,i)=>{e.lineTo(i,t)},po=Zd(0),_h=Zd(1),Qd=(e,t,i,r,a,n)=>{e.arc(t,i,r,a,n)},ef=(e,t,i,r,a,n)=>{e.arc(i,t,r,a,n)},tf=(e,t,i,r,a,n,s)=>{e.bezierCurveTo(t,i,r,a,n,s)},rf=(e,t,i,r,a,n,s)=>{e.bezierCurveTo(i,t,a,r,s,n)};function af(e){return(t,i,r,a,n)=>{let{pxRatio:s}=t;return ja(t,i,(o,l,h,c,d,u,f,_,x,p,m)=>{let{pxRound:w,points:R}=o,E,T;c.ori==0?(E=uo,T=Qd):(E=fo,T=ef);let P=Kt(R.width*s,3),v=(R.size-R.width)/2*s,b=Kt(v*2,3),U=new Path2D,W=new Path2D,{left:N,top:B,width:I,height:L}=t.bbox;po(W,N-b,B-b,I+b*2,L+b*2);let G=Z=>{if(h[Z]!=null){let O=w(u(l[Z],c,p,_)),de=w(f(h[Z],d,m,x));E(U,O+v,de),T(U,O,de,v,0,eo*2)}};if(n)n.forEach(G);else for(let Z=r;Z<=a;Z++)G(Z);return{stroke:P>0?U:null,fill:U,clip:W,flags:Sn|th}})}}function nf(e){return(t,i,r,a,n,s)=>{r!=a&&(n!=r&&s!=r&&e(t,i,r),n!=a&&s!=a&&e(t,i,a),e(t,i,s))}}var V0=nf(yn),W0=nf(En);function sf(e){return(t,i,r,a)=>ja(t,i,(n,s,o,l,h,c,d,u,f,_,x)=>{[r,a]=no(o,r,a);let p=n.pxRound,m=e?.alignGaps??n.alignGaps??0,w=I=>p(c(I,l,_,u)),R=I=>p(d(I,h,x,f)),E,T;l.ori==0?(E=yn,T=V0):(E=En,T=W0);let P=l.dir*(l.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Sn},b=v.stroke,U=!1;if(a-r>=_*4){let I=K=>t.posToVal(K,l.key,!0),L=null,G=null,Z,O,de,J=w(s[P==1?r:a]),te=w(s[r]),ne=w(s[a]),Le=I(P==1?te+1:ne-1);for(let K=P==1?r:a;K>=r&&K<=a;K+=P){let re=s[K],Ce=(P==1?re<Le:re>Le)?J:w(re),Re=o[K];Ce==J?Re!=null?(O=Re,L==null?(E(b,Ce,R(O)),Z=L=G=O):O<L?L=O:O>G&&(G=O)):Re===null&&(U=!0):(L!=null&&T(b,J,R(L),R(G),R(Z),R(O)),Re!=null?(O=Re,E(b,Ce,R(O)),L=G=Z=O):(L=G=null,Re===null&&(U=!0)),J=Ce,Le=I(J+P))}L!=null&&L!=G&&de!=J&&T(b,J,R(L),R(G),R(Z),R(O))}else for(let I=P==1?r:a;I>=r&&I<=a;I+=P){let L=o[I];L===null?U=!0:L!=null&&E(b,w(s[I]),R(L))}let[N,B]=mh(t,i);if(n.fill!=null||N!=0){let I=v.fill=new Path2D(b),L=n.fillTo(t,i,n.min,n.max,N),G=R(L),Z=w(s[r]),O=w(s[a]);P==-1&&([O,Z]=[Z,O]),E(I,O,G),E(I,Z,G)}if(!n.spanGaps){let I=[];U&&I.push(...gh(s,o,r,a,P,w,m)),v.gaps=I=n.gaps(t,i,r,a,I),v.clip=co(I,l.ori,u,f,_,x)}return B!=0&&(v.band=B==2?[Kr(t,i,r,a,b,-1),Kr(t,i,r,a,b,1)]:Kr(t,i,r,a,b,B)),v})}function j0(e){let t=Ct(e.align,1),i=Ct(e.ascDesc,!1),r=Ct(e.extend,!1);return(a,n,s,o)=>{let{pxRatio:l}=a;return ja(a,n,(h,c,d,u,f,_,x,p,m,w,R)=>{[s,o]=no(d,s,o);let E=h.pxRound,T=e?.alignGaps??h.alignGaps??0,{left:P,width:v}=a.bbox,b=ne=>E(_(ne,u,w,p)),U=ne=>E(x(ne,f,R,m)),W=u.ori==0?yn:En,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Sn},B=N.stroke,I=u.dir*(u.ori==0?1:-1),L=U(d[I==1?s:o]),G=b(c[I==1?s:o]),Z=G,O=G;r&&t==-1&&(O=P,W(B,O,L)),W(B,G,L);for(let ne=I==1?s:o;ne>=s&&ne<=o;ne+=I){let Le=d[ne];if(Le==null)continue;let K=b(c[ne]),re=U(Le);t==1?W(B,K,L):W(B,Z,re),W(B,K,re),L=re,Z=K}let de=Z;r&&t==1&&(de=P+v,W(B,de,L));let[J,te]=mh(a,n);if(h.fill!=null||J!=0){let ne=N.fill=new Path2D(B),Le=h.fillTo(a,n,h.min,h.max,J),K=U(Le);W(ne,de,K),W(ne,O,K)}if(!h.spanGaps){let ne=[];ne.push(...gh(c,d,s,o,I,b,T));let Le=h.width*l/2,K=i||t==1?Le:-Le,re=i||t==-1?-Le:Le;ne.forEach(se=>{se[0]+=K,se[1]+=re}),N.gaps=ne=h.gaps(a,n,s,o,ne),N.clip=co(ne,u.ori,p,m,w,R)}return te!=0&&(N.band=te==2?[Kr(a,n,s,o,B,-1),Kr(a,n,s,o,B,1)]:Kr(a,n,s,o,B,te)),N})}}function xd(e,t,i,r,a,n,s=It){if(e.length>1){let o=null;for(let l=0,h=1/0;l<e.length;l++)if(t[l]!==void 0){if(o!=null){let c=hi(e[l]-e[o]);c<h&&(h=c,s=hi(i(e[l],r,a,n)-i(e[o],r,a,n)))}o=l}}return s}function X0(e){e=e||_s;let t=Ct(e.size,[.6,It,1]),i=e.align||0,r=e.gap||0,a=e.radius;a=a==null?[0,0]:typeof a=="number"?[a,0]:a;let n=ut(a),s=1-t[0],o=Ct(t[1],It),l=Ct(t[2],1),h=Ct(e.disp,_s),c=Ct(e.each,f=>{}),{fill:d,stroke:u}=h;return(f,_,x,p)=>{let{pxRatio:m}=f;return ja(f,_,(w,R,E,T,P,v,b,U,W,N,B)=>{let I=w.pxRound,L=i,G=r*m,Z=o*m,O=l*m,de,J;T.ori==0?[de,J]=n(f,_):[J,de]=n(f,_);let te=T.dir*(T.ori==0?1:-1),ne=T.ori==0?po:_h,Le=T.ori==0?c:(ve,ae,Ke,Oe,je,Ot,A)=>{c(ve,ae,Ke,je,Oe,A,Ot)},K=Ct(f.bands,oh).find(ve=>ve.series[0]==_),re=K!=null?K.dir:0,se=w.fillTo(f,_,w.min,w.max,re),Ce=I(b(se,P,B,W)),Re,le,Fe,We=N,we=I(w.width*m),at=!1,_t=null,Mt=null,$e=null,St=null;d!=null&&(we==0||u!=null)&&(at=!0,_t=d.values(f,_,x,p),Mt=new Map,new Set(_t).forEach(ve=>{ve!=null&&Mt.set(ve,new Path2D)}),we>0&&($e=u.values(f,_,x,p),St=new Map,new Set($e).forEach(ve=>{ve!=null&&St.set(ve,new Path2D)})));let{x0:Nt,size:vt}=h;if(Nt!=null&&vt!=null){L=1,R=Nt.values(f,_,x,p),Nt.unit==2&&(R=R.map(Ke=>f.posToVal(U+Ke*N,T.key,!0)));let ve=vt.values(f,_,x,p);vt.unit==2?le=ve[0]*N:le=v(ve[0],T,N,U)-v(0,T,N,U),We=xd(R,E,v,T,N,U,We),Fe=We-le+G}else We=xd(R,E,v,T,N,U,We),Fe=We*s+G,le=We-Fe;Fe<1&&(Fe=0),we>=le/2&&(we=0),Fe<5&&(I=Rd);let Zt=Fe>0,mi=We-Fe-(Zt?we:0);le=I(Yl(mi,O,Z)),Re=(L==0?le/2:L==te?0:le)-L*te*((L==0?G/2:0)+(Zt?we/2:0));let Ut={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},kt=at?null:new Path2D,V=null;if(K!=null)V=f.data[K.series[1]];else{let{y0:ve,y1:ae}=h;ve!=null&&ae!=null&&(E=ae.values(f,_,x,p),V=ve.values(f,_,x,p))}let oi=de*le,ht=J*le;for(let ve=te==1?x:p;ve>=x&&ve<=p;ve+=te){let ae=E[ve];if(ae==null)continue;if(V!=null){let he=V[ve]??0;if(ae-he==0)continue;Ce=b(he,P,B,W)}let Ke=T.distr!=2||h!=null?R[ve]:ve,Oe=v(Ke,T,N,U),je=b(Ct(ae,se),P,B,W),Ot=I(Oe-Re),A=I(Fi(je,Ce)),M=I(vr(je,Ce)),j=A-M;if(ae!=null&&ae!=se){let he=ae<0?ht:oi,ie=ae<0?oi:ht;at?(we>0&&$e[ve]!=null&&ne(St.get($e[ve]),Ot,M+Ci(we/2),le,Fi(0,j-we),he,ie),_t[ve]!=null&&ne(Mt.get(_t[ve]),Ot,M+Ci(we/2),le,Fi(0,j-we),he,ie)):ne(kt,Ot,M+Ci(we/2),le,Fi(0,j-we),he,ie),Le(f,_,ve,Ot-we/2,M,le+we,j)}}return we>0?Ut.stroke=at?St:kt:at||(Ut._fill=w.width==0?w._fill:w._stroke??w._fill,Ut.width=0),Ut.fill=at?Mt:kt,Ut})}}function Y0(e,t){return(i,r,a,n)=>ja(i,r,(s,o,l,h,c,d,u,f,_,x,p)=>{[a,n]=no(l,a,n);let m=s.pxRound,w=t?.alignGaps??s.alignGaps??0,R=O=>m(d(O,h,x,f)),E=O=>m(u(O,c,p,_)),T,P,v;h.ori==0?(T=uo,v=yn,P=tf):(T=fo,v=En,P=rf);let b=h.dir*(h.ori==0?1:-1),U=R(o[b==1?a:n]),W=U,N=[],B=[];for(let O=b==1?a:n;O>=a&&O<=n;O+=b)if(l[O]!=null){let J=o[O],te=R(J);N.push(W=te),B.push(E(l[O]))}let I={stroke:e(N,B,T,v,P,m),fill:null,clip:null,band:null,gaps:null,flags:Sn},L=I.stroke,[G,Z]=mh(i,r);if(s.fill!=null||G!=0){let O=I.fill=new Path2D(L),de=s.fillTo(i,r,s.min,s.max,G),J=E(de);v(O,W,J),v(O,U,J)}if(!s.spanGaps){let O=[];O.push(...gh(o,l,a,n,b,R,w)),I.gaps=O=s.gaps(i,r,a,n,O),I.clip=co(O,h.ori,f,_,x,p)}return Z!=0&&(I.band=Z==2?[Kr(i,r,a,n,L,-1),Kr(i,r,a,n,L,1)]:Kr(i,r,a,n,L,Z)),I})}function q0(e){return Y0($0,e)}function $0(e,t,i,r,a,n){let s=e.length;if(s<2)return null;let o=new Path2D;if(i(o,e[0],t[0]),s==2)r(o,e[1],t[1]);else{let l=Array(s),h=Array(s-1),c=Array(s-1),d=Array(s-1);for(let u=0;u<s-1;u++)c[u]=t[u+1]-t[u],d[u]=e[u+1]-e[u],h[u]=c[u]/d[u];l[0]=h[0];for(let u=1;u<s-1;u++)h[u]===0||h[u-1]===0||h[u-1]>0!=h[u]>0?l[u]=0:(l[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/h[u-1]+(d[u]+2*d[u-1])/h[u]),isFinite(l[u])||(l[u]=0));l[s-1]=h[s-2];for(let u=0;u<s-1;u++)a(o,e[u]+d[u]/3,t[u]+l[u]*d[u]/3,e[u+1]-d[u]/3,t[u+1]-l[u+1]*d[u]/3,e[u+1],t[u+1])}return o}var ih=new Set;function Md(){for(let e of ih)e.syncRect(!0)}ho&&(Ga(Cg,vn,Md),Ga(Pg,vn,Md,!0),Ga(ro,vn,()=>{bi.pxRatio=_a}));var K0=sf(),J0=af();function Sd(e,t,i,r){return(r?[e[0],e[1]].concat(e.slice(2)):[e[0]].concat(e.slice(1))).map((n,s)=>rh(n,s,t,i))}function Z0(e,t){return e.map((i,r)=>r==0?{}:ni({},t,i))}function rh(e,t,i,r){return ni({},t==0?i:r,e)}function of(e,t,i){return t==null?xn:[t,i]}var Q0=of;function e_(e,t,i){return t==null?xn:io(t,i,nh,!0)}function lf(e,t,i,r){return t==null?xn:so(t,i,e.scales[r].log,!0)}var t_=lf;function hf(e,t,i,r){return t==null?xn:ah(t,i,e.scales[r].log,!0)}var i_=hf;function r_(e,t,i,r,a){let n=Fi(zu(e),zu(t)),s=t-e,o=_r(a/r*s,i);do{let l=i[o],h=r*l/s;if(h>=a&&n+(l<5?va.get(l):0)<=17)return[l,h]}while(++o<i.length);return[0,0]}function yd(e,t){let i,r;return e=e.replace(/(\d+)px/,(a,n)=>(i=Mi((r=+n)*t))+"px"),[e,i,r]}function a_(e,t){e.show&&[e.font,e.labelFont].forEach(i=>{let r=Kt(i[2]*t,1);i[0]=i[0].replace(/[0-9.]+px/,r+"px"),i[1]=r})}function bi(e,t,i){let r=e.pxRatio??_a;function a(g){r=n.pxRatio=g??_a,T.forEach(S=>a_(S,r)),ue(n.width,n.height,!0)}let n={mode:Ct(e.mode,1),pxRatio:r,setPxRatio:a};n.setPxRatio=a;let s=n.mode;function o(g,S,C,D){let H=S.valToPct(g);return D+C*(S.dir==-1?1-H:H)}function l(g,S,C,D){let H=S.valToPct(g);return D+C*(S.dir==-1?H:1-H)}function h(g,S,C,D){return S.ori==0?o(g,S,C,D):l(g,S,C,D)}n.valToPosH=o,n.valToPosV=l;let c=!1;n.status=0;let d=n.root=nr(Lg);if(e.id!=null&&(d.id=e.id),Ki(d,e.class),e.title){let g=nr(Ig,d);g.textContent=e.title}let u=gr("canvas"),f=n.ctx=u.getContext("2d"),_=nr(Ug,d);Ga("click",_,g=>{g.target===p&&(zt!=hn||Wt!=cn)&&Ei.click(n,g)},!0);let x=n.under=nr(Og,_);_.appendChild(u);let p=n.over=nr(Fg,_);e=Mn(e);let m=+Ct(e.pxAlign,1),w=vd(m);(e.plugins||[]).forEach(g=>{g.opts&&(e=g.opts(n,e)||e)});let R=e.ms||.001,E=n.series=s==1?Sd(e.series||[],ud,gd,!1):Z0(e.series||[null],md),T=n.axes=Sd(e.axes||[],cd,fd,!0),P=n.scales={},v=n.bands=e.bands||[];v.forEach(g=>{g.fill=ut(g.fill||null),g.dir=Ct(g.dir,-1)});let b=s==2?E[1].facets[0].scale:E[0].scale,U={axes:ji,series:Lt},W=(e.drawOrder||["axes","series"]).map(g=>U[g]);function N(g){let S=g.distr==3?C=>$r(C>0?C:g.clamp(n,C,g.min,g.max,g.key)):g.distr==4?C=>Bl(C,g.asinh):g.distr==100?C=>g.fwd(C):C=>C;return C=>{let D=S(C),{_min:H,_max:$}=g,oe=$-H;return(D-H)/oe}}function B(g){let S=P[g];if(S==null){let C=(e.scales||_s)[g]||_s;if(C.from!=null){B(C.from);let D=ni({},P[C.from],C,{key:g});D.valToPct=N(D),P[g]=D}else{S=P[g]=ni({},g==b?Kd:z0,C),S.key=g;let D=S.time,H=S.range,$=ma(H);if((g!=b||s==2&&!D)&&($&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?Fu:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?Fu:{mode:1,hard:H[1],soft:H[1]}},$=!1),!$&&lo(H))){let oe=H;H=(pe,_e,Ne)=>_e==null?xn:io(_e,Ne,oe)}S.range=ut(H||(D?Q0:g==b?S.distr==3?t_:S.distr==4?i_:of:S.distr==3?lf:S.distr==4?hf:e_)),S.auto=ut($?!1:S.auto),S.clamp=ut(S.clamp||B0),S._min=S._max=null,S.valToPct=N(S)}}}B("x"),B("y"),s==1&&E.forEach(g=>{B(g.scale)}),T.forEach(g=>{B(g.scale)});for(let g in e.scales)B(g);let I=P[b],L=I.distr,G,Z;I.ori==0?(Ki(d,Dg),G=o,Z=l):(Ki(d,Ng),G=l,Z=o);let O={};for(let g in P){let S=P[g];(S.min!=null||S.max!=null)&&(O[g]={min:S.min,max:S.max},S.min=S.max=null)}let de=e.tzDate||(g=>new Date(Mi(g/R))),J=e.fmtDate||uh,te=R==1?d0(de):m0(de),ne=od(de,sd(R==1?u0:p0,J)),Le=hd(de,ld(_0,J)),K=[],re=n.legend=ni({},M0,e.legend),se=n.cursor=ni({},T0,{drag:{y:s==2}},e.cursor),Ce=re.show,Re=se.show,le=re.markers;re.idxs=K,le.width=ut(le.width),le.dash=ut(le.dash),le.stroke=ut(le.stroke),le.fill=ut(le.fill);let Fe,We,we,at=[],_t=[],Mt,$e=!1,St={};if(re.live){let g=E[1]?E[1].values:null;$e=g!=null,Mt=$e?g(n,1,0):{_:0};for(let S in Mt)St[S]=hh}if(Ce)if(Fe=gr("table",Vg,d),we=gr("tbody",null,Fe),re.mount(n,Fe),$e){We=gr("thead",null,Fe,we);let g=gr("tr",null,We);gr("th",null,g);for(var Nt in Mt)gr("th",Ju,g).textContent=Nt}else Ki(Fe,jg),re.live&&Ki(Fe,Wg);let vt={show:!0},Zt={show:!1};function mi(g,S){if(S==0&&($e||!re.live||s==2))return xn;let C=[],D=gr("tr",Xg,we,we.childNodes[S]);Ki(D,g.class),g.show||Ki(D,Ha);let H=gr("th",null,D);if(le.show){let pe=nr(Yg,H);if(S>0){let _e=le.width(n,S);_e&&(pe.style.border=_e+"px "+le.dash(n,S)+" "+le.stroke(n,S)),pe.style.background=le.fill(n,S)}}let $=nr(Ju,H);g.label instanceof HTMLElement?$.appendChild(g.label):$.textContent=g.label,S>0&&(le.show||($.style.color=g.width>0?le.stroke(n,S):le.fill(n,S)),kt("click",H,pe=>{if(se._lock)return;He(pe);let _e=E.indexOf(g);if((pe.ctrlKey||pe.metaKey)!=re.isolate){let Ne=E.some((Ie,Be)=>Be>0&&Be!=_e&&Ie.show);E.forEach((Ie,Be)=>{Be>0&&Pr(Be,Ne?Be==_e?vt:Zt:vt,!0,ai.setSeries)})}else Pr(_e,{show:!g.show},!0,ai.setSeries)},!1),yt&&kt(Yu,H,pe=>{se._lock||(He(pe),Pr(E.indexOf(g),dn,!0,ai.setSeries))},!1));for(var oe in Mt){let pe=gr("td",qg,D);pe.textContent="--",C.push(pe)}return[D,C]}let Ut=new Map;function kt(g,S,C,D=!0){let H=Ut.get(S)||{},$=se.bind[g](n,S,C,D);$&&(Ga(g,S,H[g]=$),Ut.set(S,H))}function V(g,S,C){let D=Ut.get(S)||{};for(let H in D)(g==null||H==g)&&(Jl(H,S,D[H]),delete D[H]);g==null&&Ut.delete(S)}let oi=0,ht=0,ve=0,ae=0,Ke=0,Oe=0,je=Ke,Ot=Oe,A=ve,M=ae,j=0,he=0,ie=0,xe=0;n.bbox={};let Me=!1,z=!1,ce=!1,ye=!1,F=!1,Q=!1;function ue(g,S,C){(C||g!=n.width||S!=n.height)&&me(g,S),xt(!1),ce=!0,z=!0,sn()}function me(g,S){n.width=oi=ve=g,n.height=ht=ae=S,Ke=Oe=0,fe(),Je();let C=n.bbox;j=C.left=Ba(Ke*r,.5),he=C.top=Ba(Oe*r,.5),ie=C.width=Ba(ve*r,.5),xe=C.height=Ba(ae*r,.5)}let Te=3;function Ee(){let g=!1,S=0;for(;!g;){S++;let C=dt(S),D=li(S);g=S==Te||C&&D,g||(me(n.width,n.height),z=!0)}}function Ve({width:g,height:S}){ue(g,S)}n.setSize=Ve;function fe(){let g=!1,S=!1,C=!1,D=!1;T.forEach((H,$)=>{if(H.show&&H._show){let{side:oe,_size:pe}=H,_e=oe%2,Ne=H.label!=null?H.labelSize:0,Ie=pe+Ne;Ie>0&&(_e?(ve-=Ie,oe==3?(Ke+=Ie,D=!0):C=!0):(ae-=Ie,oe==0?(Oe+=Ie,g=!0):S=!0))}}),Tr[0]=g,Tr[1]=C,Tr[2]=S,Tr[3]=D,ve-=ur[1]+ur[3],Ke+=ur[3],ae-=ur[2]+ur[0],Oe+=ur[0]}function Je(){let g=Ke+ve,S=Oe+ae,C=Ke,D=Oe;function H($,oe){switch($){case 1:return g+=oe,g-oe;case 2:return S+=oe,S-oe;case 3:return C-=oe,C+oe;case 0:return D-=oe,D+oe}}T.forEach(($,oe)=>{if($.show&&$._show){let pe=$.side;$._pos=H(pe,$._size),$.label!=null&&($._lpos=H(pe,$.labelSize))}})}if(se.dataIdx==null){let g=se.hover,S=g.skip=new Set(g.skip??[]);S.add(void 0);let C=g.prox=ut(g.prox),D=g.bias??=0;se.dataIdx=(H,$,oe,pe)=>{if($==0)return oe;let _e=oe,Ne=C(H,$,oe,pe)??It,Ie=Ne>=0&&Ne<It,Be=I.ori==0?ve:ae,Qe=se.left,bt=t[0],wt=t[$];if(S.has(wt[oe])){_e=null;let ot=null,qe=null,Ge;if(D==0||D==-1)for(Ge=oe;ot==null&&--Ge>=Qt;)S.has(wt[Ge])||(ot=Ge);if(D==0||D==1)for(Ge=oe;qe==null&&++Ge<=Xt;)S.has(wt[Ge])||(qe=Ge);if(ot!=null||qe!=null)if(Ie){let Gt=ot==null?-1/0:G(bt[ot],I,Be,0),qt=qe==null?1/0:G(bt[qe],I,Be,0),xi=Qe-Gt,Dt=qt-Qe;xi<=Dt?xi<=Ne&&(_e=ot):Dt<=Ne&&(_e=qe)}else _e=qe==null?ot:ot==null?qe:oe-ot<=qe-oe?ot:qe}else Ie&&hi(Qe-G(bt[oe],I,Be,0))>Ne&&(_e=null);return _e}}let He=g=>{se.event=g};se.idxs=K,se._lock=!1;let Xe=se.points;Xe.show=ut(Xe.show),Xe.size=ut(Xe.size),Xe.stroke=ut(Xe.stroke),Xe.width=ut(Xe.width),Xe.fill=ut(Xe.fill);let Ae=n.focus=ni({},e.focus||{alpha:.3},se.focus),yt=Ae.prox>=0,Et=yt&&Xe.one,Ni=[],wr=[],la=[];function ts(g,S){let C=Xe.show(n,S);if(C instanceof HTMLElement)return Ki(C,Gg),Ki(C,g.class),Ur(C,-10,-10,ve,ae),p.insertBefore(C,Ni[S]),C}function is(g,S){if(s==1||S>0){let C=s==1&&P[g.scale].time,D=g.value;g.value=C?Vu(D)?hd(de,ld(D,J)):D||Le:D||O0,g.label=g.label||(C?R0:A0)}if(Et||S>0){g.width=g.width==null?1:g.width,g.paths=g.paths||K0||mg,g.fillTo=ut(g.fillTo||H0),g.pxAlign=+Ct(g.pxAlign,m),g.pxRound=vd(g.pxAlign),g.stroke=ut(g.stroke||null),g.fill=ut(g.fill||null),g._stroke=g._fill=g._paths=g._focus=null;let C=F0(Fi(1,g.width),1),D=g.points=ni({},{size:C,width:Fi(1,C*.2),stroke:g.stroke,space:C*2,paths:J0,_stroke:null,_fill:null},g.points);D.show=ut(D.show),D.filter=ut(D.filter),D.fill=ut(D.fill),D.stroke=ut(D.stroke),D.paths=ut(D.paths),D.pxAlign=g.pxAlign}if(Ce){let C=mi(g,S);at.splice(S,0,C[0]),_t.splice(S,0,C[1]),re.values.push(null)}if(Re){K.splice(S,0,null);let C=null;Et?S==0&&(C=ts(g,S)):S>0&&(C=ts(g,S)),Ni.splice(S,0,C),wr.splice(S,0,0),la.splice(S,0,0)}vi("addSeries",S)}function Xr(g,S){S=S??E.length,g=s==1?rh(g,S,ud,gd):rh(g,S,{},md),E.splice(S,0,g),is(E[S],S)}n.addSeries=Xr;function rs(g){if(E.splice(g,1),Ce){re.values.splice(g,1),_t.splice(g,1);let S=at.splice(g,1)[0];V(null,S.firstChild),S.remove()}Re&&(K.splice(g,1),Ni.splice(g,1)[0].remove(),wr.splice(g,1),la.splice(g,1)),vi("delSeries",g)}n.delSeries=rs;let Tr=[!1,!1,!1,!1];function js(g,S){if(g._show=g.show,g.show){let C=g.side%2,D=P[g.scale];D==null&&(g.scale=C?E[1].scale:b,D=P[g.scale]);let H=D.time;g.size=ut(g.size),g.space=ut(g.space),g.rotate=ut(g.rotate),ma(g.incrs)&&g.incrs.forEach(oe=>{!va.has(oe)&&va.set(oe,Ld(oe))}),g.incrs=ut(g.incrs||(D.distr==2?l0:H?R==1?c0:f0:za)),g.splits=ut(g.splits||(H&&D.distr==1?te:D.distr==3?Ql:D.distr==4?L0:P0)),g.stroke=ut(g.stroke),g.grid.stroke=ut(g.grid.stroke),g.ticks.stroke=ut(g.ticks.stroke),g.border.stroke=ut(g.border.stroke);let $=g.values;g.values=ma($)&&!ma($[0])?ut($):H?ma($)?od(de,sd($,J)):Vu($)?g0(de,$):$||ne:$||C0,g.filter=ut(g.filter||(D.distr>=3&&D.log==10?I0:D.distr==3&&D.log==2?U0:Cd)),g.font=yd(g.font,r),g.labelFont=yd(g.labelFont,r),g._size=g.size(n,null,S,0),g._space=g._rotate=g._incrs=g._found=g._splits=g._values=null,g._size>0&&(Tr[S]=!0,g._el=nr(kg,_))}}function Ar(g,S,C,D){let[H,$,oe,pe]=C,_e=S%2,Ne=0;return _e==0&&(pe||$)&&(Ne=S==0&&!H||S==2&&!oe?Mi(cd.size/3):0),_e==1&&(H||oe)&&(Ne=S==1&&!$||S==3&&!pe?Mi(fd.size/2):0),Ne}let as=n.padding=(e.padding||[Ar,Ar,Ar,Ar]).map(g=>ut(Ct(g,Ar))),ur=n._padding=as.map((g,S)=>g(n,S,Tr,0)),jt,Qt=null,Xt=null,Da=s==1?E[0].idxs:null,Wi=null,Na=!1;function Xs(g,S){if(t=g??[],n.data=n._data=t,s==2){jt=0;for(let C=1;C<E.length;C++)jt+=t[C][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),Wi=t[0],jt=Wi.length;let C=t;if(L==2){C=t.slice();let D=C[0]=Array(jt);for(let H=0;H<jt;H++)D[H]=H}n._data=t=C}if(xt(!0),vi("setData"),L==2&&(ce=!0),S!==!1){let C=I;C.auto(n,Na)?nn():ua(b,C.min,C.max),ye=ye||se.left>=0,Q=!0,sn()}}n.setData=Xs;function nn(){Na=!0;let g,S;s==1&&(jt>0?(Qt=Da[0]=0,Xt=Da[1]=jt-1,g=t[0][Qt],S=t[0][Xt],L==2?(g=Qt,S=Xt):g==S&&(L==3?[g,S]=so(g,g,I.log,!1):L==4?[g,S]=ah(g,g,I.log,!1):I.time?S=g+Mi(86400/R):[g,S]=io(g,S,nh,!0))):(Qt=Da[0]=g=null,Xt=Da[1]=S=null)),ua(b,g,S)}let y,k,ee,q,Y,ge,be,Se,De,Ue;function tt(g,S,C,D,H,$){g??=ju,C??=oh,D??="butt",H??=ju,$??="round",g!=y&&(f.strokeStyle=y=g),H!=k&&(f.fillStyle=k=H),S!=ee&&(f.lineWidth=ee=S),$!=Y&&(f.lineJoin=Y=$),D!=ge&&(f.lineCap=ge=D),C!=q&&f.setLineDash(q=C)}function ct(g,S,C,D){S!=k&&(f.fillStyle=k=S),g!=be&&(f.font=be=g),C!=Se&&(f.textAlign=Se=C),D!=De&&(f.textBaseline=De=D)}function ke(g,S,C,D,H=0){if(D.length>0&&g.auto(n,Na)&&(S==null||S.min==null)){let $=Ct(Qt,0),oe=Ct(Xt,D.length-1),pe=C.min==null?hg(D,$,oe,H,g.distr==3):[C.min,C.max];g.min=vr(g.min,C.min=pe[0]),g.max=Fi(g.max,C.max=pe[1])}}let gt={min:null,max:null};function Yt(){for(let D in P){let H=P[D];O[D]==null&&(H.min==null||O[b]!=null&&H.auto(n,Na))&&(O[D]=gt)}for(let D in P){let H=P[D];O[D]==null&&H.from!=null&&O[H.from]!=null&&(O[D]=gt)}O[b]!=null&&xt(!0);let g={};for(let D in O){let H=O[D];if(H!=null){let $=g[D]=Mn(P[D],vg);if(H.min!=null)ni($,H);else if(D!=b||s==2)if(jt==0&&$.from==null){let oe=$.range(n,null,null,D);$.min=oe[0],$.max=oe[1]}else $.min=It,$.max=-It}}if(jt>0){E.forEach((D,H)=>{if(s==1){let $=D.scale,oe=O[$];if(oe==null)return;let pe=g[$];if(H==0){let _e=pe.range(n,pe.min,pe.max,$);pe.min=_e[0],pe.max=_e[1],Qt=_r(pe.min,t[0]),Xt=_r(pe.max,t[0]),Xt-Qt>1&&(t[0][Qt]<pe.min&&Qt++,t[0][Xt]>pe.max&&Xt--),D.min=Wi[Qt],D.max=Wi[Xt]}else D.show&&D.auto&&ke(pe,oe,D,t[H],D.sorted);D.idxs[0]=Qt,D.idxs[1]=Xt}else if(H>0&&D.show&&D.auto){let[$,oe]=D.facets,pe=$.scale,_e=oe.scale,[Ne,Ie]=t[H],Be=g[pe],Qe=g[_e];Be!=null&&ke(Be,O[pe],$,Ne,$.sorted),Qe!=null&&ke(Qe,O[_e],oe,Ie,oe.sorted),D.min=oe.min,D.max=oe.max}});for(let D in g){let H=g[D],$=O[D];if(H.from==null&&($==null||$.min==null)){let oe=H.range(n,H.min==It?null:H.min,H.max==-It?null:H.max,D);H.min=oe[0],H.max=oe[1]}}}for(let D in g){let H=g[D];if(H.from!=null){let $=g[H.from];if($.min==null)H.min=H.max=null;else{let oe=H.range(n,$.min,$.max,D);H.min=oe[0],H.max=oe[1]}}}let S={},C=!1;for(let D in g){let H=g[D],$=P[D];if($.min!=H.min||$.max!=H.max){$.min=H.min,$.max=H.max;let oe=$.distr;$._min=oe==3?$r($.min):oe==4?Bl($.min,$.asinh):oe==100?$.fwd($.min):$.min,$._max=oe==3?$r($.max):oe==4?Bl($.max,$.asinh):oe==100?$.fwd($.max):$.max,S[D]=C=!0}}if(C){E.forEach((D,H)=>{s==2?H>0&&S.y&&(D._paths=null):S[D.scale]&&(D._paths=null)});for(let D in S)ce=!0,vi("setScale",D);Re&&se.left>=0&&(ye=Q=!0)}for(let D in O)O[D]=null}function Rt(g){let S=Yl(Qt-1,0,jt-1),C=Yl(Xt+1,0,jt-1);for(;g[S]==null&&S>0;)S--;for(;g[C]==null&&C<jt-1;)C++;return[S,C]}function Lt(){if(jt>0){let g=E.some(S=>S._focus)&&Ue!=Ae.alpha;g&&(f.globalAlpha=Ue=Ae.alpha),E.forEach((S,C)=>{if(C>0&&S.show&&(Bt(C,!1),Bt(C,!0),S._paths==null)){let D=Ue;Ue!=S.alpha&&(f.globalAlpha=Ue=S.alpha);let H=s==2?[0,t[C][0].length-1]:Rt(t[C]);S._paths=S.paths(n,C,H[0],H[1]),Ue!=D&&(f.globalAlpha=Ue=D)}}),E.forEach((S,C)=>{if(C>0&&S.show){let D=Ue;Ue!=S.alpha&&(f.globalAlpha=Ue=S.alpha),S._paths!=null&&ze(C,!1);{let H=S._paths!=null?S._paths.gaps:null,$=S.points.show(n,C,Qt,Xt,H),oe=S.points.filter(n,C,$,H);($||oe)&&(S.points._paths=S.points.paths(n,C,Qt,Xt,oe),ze(C,!0))}Ue!=D&&(f.globalAlpha=Ue=D),vi("drawSeries",C)}}),g&&(f.globalAlpha=Ue=1)}}function Bt(g,S){let C=S?E[g].points:E[g];C._stroke=C.stroke(n,g),C._fill=C.fill(n,g)}function ze(g,S){let C=S?E[g].points:E[g],{stroke:D,fill:H,clip:$,flags:oe,_stroke:pe=C._stroke,_fill:_e=C._fill,_width:Ne=C.width}=C._paths;Ne=Kt(Ne*r,3);let Ie=null,Be=Ne%2/2;S&&_e==null&&(_e=Ne>0?"#fff":pe);let Qe=C.pxAlign==1&&Be>0;if(Qe&&f.translate(Be,Be),!S){let bt=j-Ne/2,wt=he-Ne/2,ot=ie+Ne,qe=xe+Ne;Ie=new Path2D,Ie.rect(bt,wt,ot,qe)}S?dr(pe,Ne,C.dash,C.cap,_e,D,H,oe,$):yi(g,pe,Ne,C.dash,C.cap,_e,D,H,oe,Ie,$),Qe&&f.translate(-Be,-Be)}function yi(g,S,C,D,H,$,oe,pe,_e,Ne,Ie){let Be=!1;_e!=0&&v.forEach((Qe,bt)=>{if(Qe.series[0]==g){let wt=E[Qe.series[1]],ot=t[Qe.series[1]],qe=(wt._paths||_s).band;ma(qe)&&(qe=Qe.dir==1?qe[0]:qe[1]);let Ge,Gt=null;wt.show&&qe&&ug(ot,Qt,Xt)?(Gt=Qe.fill(n,bt)||$,Ge=wt._paths.clip):qe=null,dr(S,C,D,H,Gt,oe,pe,_e,Ne,Ie,Ge,qe),Be=!0}}),Be||dr(S,C,D,H,$,oe,pe,_e,Ne,Ie)}let Rr=Sn|th;function dr(g,S,C,D,H,$,oe,pe,_e,Ne,Ie,Be){tt(g,S,C,D,H),(_e||Ne||Be)&&(f.save(),_e&&f.clip(_e),Ne&&f.clip(Ne)),Be?(pe&Rr)==Rr?(f.clip(Be),Ie&&f.clip(Ie),Yr(H,oe),ei(g,$,S)):pe&th?(Yr(H,oe),f.clip(Be),ei(g,$,S)):pe&Sn&&(f.save(),f.clip(Be),Ie&&f.clip(Ie),Yr(H,oe),f.restore(),ei(g,$,S)):(Yr(H,oe),ei(g,$,S)),(_e||Ne||Be)&&f.restore()}function ei(g,S,C){C>0&&(S instanceof Map?S.forEach((D,H)=>{f.strokeStyle=y=H,f.stroke(D)}):S!=null&&g&&f.stroke(S))}function Yr(g,S){S instanceof Map?S.forEach((C,D)=>{f.fillStyle=k=D,f.fill(C)}):S!=null&&g&&f.fill(S)}function Cr(g,S,C,D){let H=T[g],$;if(D<=0)$=[0,0];else{let oe=H._space=H.space(n,g,S,C,D),pe=H._incrs=H.incrs(n,g,S,C,D,oe);$=r_(S,C,pe,D,oe)}return H._found=$}function fr(g,S,C,D,H,$,oe,pe,_e,Ne){let Ie=oe%2/2;m==1&&f.translate(Ie,Ie),tt(pe,oe,_e,Ne,pe),f.beginPath();let Be,Qe,bt,wt,ot=H+(D==0||D==3?-$:$);C==0?(Qe=H,wt=ot):(Be=H,bt=ot);for(let qe=0;qe<g.length;qe++)S[qe]!=null&&(C==0?Be=bt=g[qe]:Qe=wt=g[qe],f.moveTo(Be,Qe),f.lineTo(bt,wt));f.stroke(),m==1&&f.translate(-Ie,-Ie)}function dt(g){let S=!0;return T.forEach((C,D)=>{if(!C.show)return;let H=P[C.scale];if(H.min==null){C._show&&(S=!1,C._show=!1,xt(!1));return}else C._show||(S=!1,C._show=!0,xt(!1));let $=C.side,oe=$%2,{min:pe,max:_e}=H,[Ne,Ie]=Cr(D,pe,_e,oe==0?ve:ae);if(Ie==0)return;let Be=H.distr==2,Qe=C._splits=C.splits(n,D,pe,_e,Ne,Ie,Be),bt=H.distr==2?Qe.map(Ge=>Wi[Ge]):Qe,wt=H.distr==2?Wi[Qe[1]]-Wi[Qe[0]]:Ne,ot=C._values=C.values(n,C.filter(n,bt,D,Ie,wt),D,Ie,wt);C._rotate=$==2?C.rotate(n,ot,D,Ie):0;let qe=C._size;C._size=Ji(C.size(n,ot,D,g)),qe!=null&&C._size!=qe&&(S=!1)}),S}function li(g){let S=!0;return as.forEach((C,D)=>{let H=C(n,D,Tr,g);H!=ur[D]&&(S=!1),ur[D]=H}),S}function ji(){for(let g=0;g<T.length;g++){let S=T[g];if(!S.show||!S._show)continue;let C=S.side,D=C%2,H,$,oe=S.stroke(n,g),pe=C==0||C==3?-1:1,[_e,Ne]=S._found;if(S.label!=null){let Ui=S.labelGap*pe,$i=Mi((S._lpos+Ui)*r);ct(S.labelFont[0],oe,"center",C==2?cs:Wu),f.save(),D==1?(H=$=0,f.translate($i,Mi(he+xe/2)),f.rotate((C==3?-eo:eo)/2)):(H=Mi(j+ie/2),$=$i);let Oa=Ad(S.label)?S.label(n,g,_e,Ne):S.label;f.fillText(Oa,H,$),f.restore()}if(Ne==0)continue;let Ie=P[S.scale],Be=D==0?ie:xe,Qe=D==0?j:he,bt=S._splits,wt=Ie.distr==2?bt.map(Ui=>Wi[Ui]):bt,ot=Ie.distr==2?Wi[bt[1]]-Wi[bt[0]]:_e,qe=S.ticks,Ge=S.border,Gt=qe.show?qe.size:0,qt=Mi(Gt*r),xi=Mi((S.alignTo==2?S._size-Gt-S.gap:S.gap)*r),Dt=S._rotate*-eo/180,$t=w(S._pos*r),Yi=(qt+xi)*pe,Ii=$t+Yi;$=D==0?Ii:0,H=D==1?Ii:0;let rr=S.font[0],pr=S.align==1?gn:S.align==2?zl:Dt>0?gn:Dt<0?zl:D==0?"center":C==3?zl:gn,Dr=Dt||D==1?"middle":C==2?cs:Wu;ct(rr,oe,pr,Dr);let qi=S.font[1]*S.lineGap,ar=bt.map(Ui=>w(h(Ui,Ie,Be,Qe))),mr=S._values;for(let Ui=0;Ui<mr.length;Ui++){let $i=mr[Ui];if($i!=null){D==0?H=ar[Ui]:$=ar[Ui],$i=""+$i;let Oa=$i.indexOf(`
`)==-1?[$i]:$i.split(/\n/gm);for(let Oi=0;Oi<Oa.length;Oi++){let bu=Oa[Oi];Dt?(f.save(),f.translate(H,$+Oi*qi),f.rotate(Dt),f.fillText(bu,0,0),f.restore()):f.fillText(bu,H,$+Oi*qi)}}}qe.show&&fr(ar,qe.filter(n,wt,g,Ne,ot),D,C,$t,qt,Kt(qe.width*r,3),qe.stroke(n,g),qe.dash,qe.cap);let Nr=S.grid;Nr.show&&fr(ar,Nr.filter(n,wt,g,Ne,ot),D,D==0?2:1,D==0?he:j,D==0?xe:ie,Kt(Nr.width*r,3),Nr.stroke(n,g),Nr.dash,Nr.cap),Ge.show&&fr([$t],[1],D==0?1:0,D==0?1:2,D==1?he:j,D==1?xe:ie,Kt(Ge.width*r,3),Ge.stroke(n,g),Ge.dash,Ge.cap)}vi("drawAxes")}function xt(g){E.forEach((S,C)=>{C>0&&(S._paths=null,g&&(s==1?(S.min=null,S.max=null):S.facets.forEach(D=>{D.min=null,D.max=null})))})}let ri=!1,Xi=!1,ha=[];function Bm(){Xi=!1;for(let g=0;g<ha.length;g++)vi(...ha[g]);ha.length=0}function sn(){ri||(wg(su),ri=!0)}function zm(g,S=!1){ri=!0,Xi=S,g(n),su(),S&&ha.length>0&&queueMicrotask(Bm)}n.batch=zm;function su(){if(Me&&(Yt(),Me=!1),ce&&(Ee(),ce=!1),z){if(Vt(x,gn,Ke),Vt(x,cs,Oe),Vt(x,fs,ve),Vt(x,ps,ae),Vt(p,gn,Ke),Vt(p,cs,Oe),Vt(p,fs,ve),Vt(p,ps,ae),Vt(_,fs,oi),Vt(_,ps,ht),u.width=Mi(oi*r),u.height=Mi(ht*r),T.forEach(({_el:g,_show:S,_size:C,_pos:D,side:H})=>{if(g!=null)if(S){let $=H===3||H===0?C:0,oe=H%2==1;Vt(g,oe?"left":"top",D-$),Vt(g,oe?"width":"height",C),Vt(g,oe?"top":"left",oe?Oe:Ke),Vt(g,oe?"height":"width",oe?ae:ve),Kl(g,Ha)}else Ki(g,Ha)}),y=k=ee=Y=ge=be=Se=De=q=null,Ue=1,os(!0),Ke!=je||Oe!=Ot||ve!=A||ae!=M){xt(!1);let g=ve/A,S=ae/M;if(Re&&!ye&&se.left>=0){se.left*=g,se.top*=S,on&&Ur(on,Mi(se.left),0,ve,ae),ln&&Ur(ln,0,Mi(se.top),ve,ae);for(let C=0;C<Ni.length;C++){let D=Ni[C];D!=null&&(wr[C]*=g,la[C]*=S,Ur(D,Ji(wr[C]),Ji(la[C]),ve,ae))}}if(Ht.show&&!F&&Ht.left>=0&&Ht.width>0){Ht.left*=g,Ht.width*=g,Ht.top*=S,Ht.height*=S;for(let C in Pl)Vt(un,C,Ht[C])}je=Ke,Ot=Oe,A=ve,M=ae}vi("setSize"),z=!1}oi>0&&ht>0&&(f.clearRect(0,0,u.width,u.height),vi("drawClear"),W.forEach(g=>g()),vi("draw")),Ht.show&&F&&(Ys(Ht),F=!1),Re&&ye&&(Ua(null,!0,!1),ye=!1),re.show&&re.live&&Q&&(Rl(),Q=!1),c||(c=!0,n.status=1,vi("ready")),Na=!1,ri=!1}n.clearCache=()=>{E.forEach((g,S)=>{S>0&&(g._paths=null)})},n.redraw=(g,S)=>{ce=S||!1,g!==!1?ua(b,I.min,I.max):sn()};function wl(g,S){let C=P[g];if(C.from==null){if(jt==0){let D=C.range(n,S.min,S.max,g);S.min=D[0],S.max=D[1]}if(S.min>S.max){let D=S.min;S.min=S.max,S.max=D}if(jt>1&&S.min!=null&&S.max!=null&&S.max-S.min<1e-16)return;g==b&&C.distr==2&&jt>0&&(S.min=_r(S.min,t[0]),S.max=_r(S.max,t[0]),S.min==S.max&&S.max++),O[g]=S,Me=!0,sn()}}n.setScale=wl;let Tl,Al,on,ln,ou,lu,hn,cn,hu,cu,zt,Wt,ca=!1,Ei=se.drag,gi=Ei.x,_i=Ei.y;Re&&(se.x&&(Tl=nr(zg,p)),se.y&&(Al=nr(Hg,p)),I.ori==0?(on=Tl,ln=Al):(on=Al,ln=Tl),zt=se.left,Wt=se.top);let Ht=n.select=ni({show:!0,over:!0,left:0,width:0,top:0,height:0},e.select),un=Ht.show?nr(Bg,Ht.over?p:x):null;function Ys(g,S){if(Ht.show){for(let C in g)Ht[C]=g[C],C in Pl&&Vt(un,C,g[C]);S!==!1&&vi("setSelect")}}n.setSelect=Ys;function Hm(g){if(E[g].show)Ce&&Kl(at[g],Ha);else if(Ce&&Ki(at[g],Ha),Re){let C=Et?Ni[0]:Ni[g];C!=null&&Ur(C,-10,-10,ve,ae)}}function ua(g,S,C){wl(g,{min:S,max:C})}function Pr(g,S,C,D){S.focus!=null&&Xm(g),S.show!=null&&E.forEach((H,$)=>{$>0&&(g==$||g==null)&&(H.show=S.show,Hm($),s==2?(ua(H.facets[0].scale,null,null),ua(H.facets[1].scale,null,null)):ua(H.scale,null,null),sn())}),C!==!1&&vi("setSeries",g,S),D&&ls("setSeries",n,g,S)}n.setSeries=Pr;function Gm(g,S){ni(v[g],S)}function Vm(g,S){g.fill=ut(g.fill||null),g.dir=Ct(g.dir,-1),S=S??v.length,v.splice(S,0,g)}function Wm(g){g==null?v.length=0:v.splice(g,1)}n.addBand=Vm,n.setBand=Gm,n.delBand=Wm;function jm(g,S){E[g].alpha=S,Re&&Ni[g]!=null&&(Ni[g].style.opacity=S),Ce&&at[g]&&(at[g].style.opacity=S)}let qr,da,Ia,dn={focus:!0};function Xm(g){if(g!=Ia){let S=g==null,C=Ae.alpha!=1;E.forEach((D,H)=>{if(s==1||H>0){let $=S||H==0||H==g;D._focus=S?null:$,C&&jm(H,$?1:Ae.alpha)}}),Ia=g,C&&sn()}}Ce&&yt&&kt(qu,Fe,g=>{se._lock||(He(g),Ia!=null&&Pr(null,dn,!0,ai.setSeries))});function Lr(g,S,C){let D=P[S];C&&(g=g/r-(D.ori==1?Oe:Ke));let H=ve;D.ori==1&&(H=ae,g=H-g),D.dir==-1&&(g=H-g);let $=D._min,oe=D._max,pe=g/H,_e=$+(oe-$)*pe,Ne=D.distr;return Ne==3?ga(10,_e):Ne==4?fg(_e,D.asinh):Ne==100?D.bwd(_e):_e}function Ym(g,S){let C=Lr(g,b,S);return _r(C,t[0],Qt,Xt)}n.valToIdx=g=>_r(g,t[0]),n.posToIdx=Ym,n.posToVal=Lr,n.valToPos=(g,S,C)=>P[S].ori==0?o(g,P[S],C?ie:ve,C?j:0):l(g,P[S],C?xe:ae,C?he:0),n.setCursor=(g,S,C)=>{zt=g.left,Wt=g.top,Ua(null,S,C)};function uu(g,S){Vt(un,gn,Ht.left=g),Vt(un,fs,Ht.width=S)}function du(g,S){Vt(un,cs,Ht.top=g),Vt(un,ps,Ht.height=S)}let ns=I.ori==0?uu:du,ss=I.ori==1?uu:du;function qm(){if(Ce&&re.live)for(let g=s==2?1:0;g<E.length;g++){if(g==0&&$e)continue;let S=re.values[g],C=0;for(let D in S)_t[g][C++].firstChild.nodeValue=S[D]}}function Rl(g,S){if(g!=null&&(g.idxs?g.idxs.forEach((C,D)=>{K[D]=C}):_g(g.idx)||K.fill(g.idx),re.idx=K[0]),Ce&&re.live){for(let C=0;C<E.length;C++)(C>0||s==1&&!$e)&&$m(C,K[C]);qm()}Q=!1,S!==!1&&vi("setLegend")}n.setLegend=Rl;function $m(g,S){let C=E[g],D=g==0&&L==2?Wi:t[g],H;$e?H=C.values(n,g,S)??St:(H=C.value(n,S==null?null:D[S],g,S),H=H==null?St:{_:H}),re.values[g]=H}function Ua(g,S,C){hu=zt,cu=Wt,[zt,Wt]=se.move(n,zt,Wt),se.left=zt,se.top=Wt,Re&&(on&&Ur(on,Mi(zt),0,ve,ae),ln&&Ur(ln,0,Mi(Wt),ve,ae));let D,H=Qt>Xt;qr=It,da=null;let $=I.ori==0?ve:ae,oe=I.ori==1?ve:ae;if(zt<0||jt==0||H){D=se.idx=null;for(let pe=0;pe<E.length;pe++){let _e=Ni[pe];_e!=null&&Ur(_e,-10,-10,ve,ae)}yt&&Pr(null,dn,!0,g==null&&ai.setSeries),re.live&&(K.fill(D),Q=!0)}else{let pe,_e,Ne;s==1&&(pe=I.ori==0?zt:Wt,_e=Lr(pe,b),D=se.idx=_r(_e,t[0],Qt,Xt),Ne=G(t[0][D],I,$,0));let Ie=-10,Be=-10,Qe=0,bt=0,wt=!0,ot="",qe="";for(let Ge=s==2?1:0;Ge<E.length;Ge++){let Gt=E[Ge],qt=K[Ge],xi=qt==null?null:s==1?t[Ge][qt]:t[Ge][1][qt],Dt=se.dataIdx(n,Ge,D,_e),$t=Dt==null?null:s==1?t[Ge][Dt]:t[Ge][1][Dt];if(Q=Q||$t!=xi||Dt!=qt,K[Ge]=Dt,Ge>0&&Gt.show){let Yi=Dt==null?-10:Dt==D?Ne:G(s==1?t[0][Dt]:t[Ge][0][Dt],I,$,0),Ii=$t==null?-10:Z($t,s==1?P[Gt.scale]:P[Gt.facets[1].scale],oe,0);if(yt&&$t!=null){let rr=I.ori==1?zt:Wt,pr=hi(Ae.dist(n,Ge,Dt,Ii,rr));if(pr<qr){let Dr=Ae.bias;if(Dr!=0){let qi=Lr(rr,Gt.scale),ar=$t>=0?1:-1,mr=qi>=0?1:-1;mr==ar&&(mr==1?Dr==1?$t>=qi:$t<=qi:Dr==1?$t<=qi:$t>=qi)&&(qr=pr,da=Ge)}else qr=pr,da=Ge}}if(Q||Et){let rr,pr;I.ori==0?(rr=Yi,pr=Ii):(rr=Ii,pr=Yi);let Dr,qi,ar,mr,Nr,Ui,$i=!0,Oa=Xe.bbox;if(Oa!=null){$i=!1;let Oi=Oa(n,Ge);ar=Oi.left,mr=Oi.top,Dr=Oi.width,qi=Oi.height}else ar=rr,mr=pr,Dr=qi=Xe.size(n,Ge);if(Ui=Xe.fill(n,Ge),Nr=Xe.stroke(n,Ge),Et)Ge==da&&qr<=Ae.prox&&(Ie=ar,Be=mr,Qe=Dr,bt=qi,wt=$i,ot=Ui,qe=Nr);else{let Oi=Ni[Ge];Oi!=null&&(wr[Ge]=ar,la[Ge]=mr,id(Oi,Dr,qi,$i),ed(Oi,Ui,Nr),Ur(Oi,Ji(ar),Ji(mr),ve,ae))}}}}if(Et){let Ge=Ae.prox,Gt=Ia==null?qr<=Ge:qr>Ge||da!=Ia;if(Q||Gt){let qt=Ni[0];qt!=null&&(wr[0]=Ie,la[0]=Be,id(qt,Qe,bt,wt),ed(qt,ot,qe),Ur(qt,Ji(Ie),Ji(Be),ve,ae))}}}if(Ht.show&&ca)if(g!=null){let[pe,_e]=ai.scales,[Ne,Ie]=ai.match,[Be,Qe]=g.cursor.sync.scales,bt=g.cursor.drag;if(gi=bt._x,_i=bt._y,gi||_i){let{left:wt,top:ot,width:qe,height:Ge}=g.select,Gt=g.scales[Be].ori,qt=g.posToVal,xi,Dt,$t,Yi,Ii,rr=pe!=null&&Ne(pe,Be),pr=_e!=null&&Ie(_e,Qe);rr&&gi?(Gt==0?(xi=wt,Dt=qe):(xi=ot,Dt=Ge),$t=P[pe],Yi=G(qt(xi,Be),$t,$,0),Ii=G(qt(xi+Dt,Be),$t,$,0),ns(vr(Yi,Ii),hi(Ii-Yi))):ns(0,$),pr&&_i?(Gt==1?(xi=wt,Dt=qe):(xi=ot,Dt=Ge),$t=P[_e],Yi=Z(qt(xi,Qe),$t,oe,0),Ii=Z(qt(xi+Dt,Qe),$t,oe,0),ss(vr(Yi,Ii),hi(Ii-Yi))):ss(0,oe)}else Ll()}else{let pe=hi(hu-ou),_e=hi(cu-lu);if(I.ori==1){let Qe=pe;pe=_e,_e=Qe}gi=Ei.x&&pe>=Ei.dist,_i=Ei.y&&_e>=Ei.dist;let Ne=Ei.uni;Ne!=null?gi&&_i&&(gi=pe>=Ne,_i=_e>=Ne,!gi&&!_i&&(_e>pe?_i=!0:gi=!0)):Ei.x&&Ei.y&&(gi||_i)&&(gi=_i=!0);let Ie,Be;gi&&(I.ori==0?(Ie=hn,Be=zt):(Ie=cn,Be=Wt),ns(vr(Ie,Be),hi(Be-Ie)),_i||ss(0,oe)),_i&&(I.ori==1?(Ie=hn,Be=zt):(Ie=cn,Be=Wt),ss(vr(Ie,Be),hi(Be-Ie)),gi||ns(0,$)),!gi&&!_i&&(ns(0,0),ss(0,0))}if(Ei._x=gi,Ei._y=_i,g==null){if(C){if(Eu!=null){let[pe,_e]=ai.scales;ai.values[0]=pe!=null?Lr(I.ori==0?zt:Wt,pe):null,ai.values[1]=_e!=null?Lr(I.ori==1?zt:Wt,_e):null}ls(Hl,n,zt,Wt,ve,ae,D)}if(yt){let pe=C&&ai.setSeries,_e=Ae.prox;Ia==null?qr<=_e&&Pr(da,dn,!0,pe):qr>_e?Pr(null,dn,!0,pe):da!=Ia&&Pr(da,dn,!0,pe)}}Q&&(re.idx=D,Rl()),S!==!1&&vi("setCursor")}let fa=null;Object.defineProperty(n,"rect",{get(){return fa==null&&os(!1),fa}});function os(g=!1){g?fa=null:(fa=p.getBoundingClientRect(),vi("syncRect",fa))}function fu(g,S,C,D,H,$,oe){se._lock||ca&&g!=null&&g.movementX==0&&g.movementY==0||(Cl(g,S,C,D,H,$,oe,!1,g!=null),g!=null?Ua(null,!0,!0):Ua(S,!0,!1))}function Cl(g,S,C,D,H,$,oe,pe,_e){if(fa==null&&os(!1),He(g),g!=null)C=g.clientX-fa.left,D=g.clientY-fa.top;else{if(C<0||D<0){zt=-10,Wt=-10;return}let[Ne,Ie]=ai.scales,Be=S.cursor.sync,[Qe,bt]=Be.values,[wt,ot]=Be.scales,[qe,Ge]=ai.match,Gt=S.axes[0].side%2==1,qt=I.ori==0?ve:ae,xi=I.ori==1?ve:ae,Dt=Gt?$:H,$t=Gt?H:$,Yi=Gt?D:C,Ii=Gt?C:D;if(wt!=null?C=qe(Ne,wt)?h(Qe,P[Ne],qt,0):-10:C=qt*(Yi/Dt),ot!=null?D=Ge(Ie,ot)?h(bt,P[Ie],xi,0):-10:D=xi*(Ii/$t),I.ori==1){let rr=C;C=D,D=rr}}_e&&(S==null||S.cursor.event.type==Hl)&&((C<=1||C>=ve-1)&&(C=Ba(C,ve)),(D<=1||D>=ae-1)&&(D=Ba(D,ae))),pe?(ou=C,lu=D,[hn,cn]=se.move(n,C,D)):(zt=C,Wt=D)}let Pl={width:0,height:0,left:0,top:0};function Ll(){Ys(Pl,!1)}let pu,mu,gu,_u;function vu(g,S,C,D,H,$,oe){ca=!0,gi=_i=Ei._x=Ei._y=!1,Cl(g,S,C,D,H,$,oe,!0,!1),g!=null&&(kt(Gl,ql,xu,!1),ls(Xu,n,hn,cn,ve,ae,null));let{left:pe,top:_e,width:Ne,height:Ie}=Ht;pu=pe,mu=_e,gu=Ne,_u=Ie}function xu(g,S,C,D,H,$,oe){ca=Ei._x=Ei._y=!1,Cl(g,S,C,D,H,$,oe,!1,!0);let{left:pe,top:_e,width:Ne,height:Ie}=Ht,Be=Ne>0||Ie>0,Qe=pu!=pe||mu!=_e||gu!=Ne||_u!=Ie;if(Be&&Qe&&Ys(Ht),Ei.setScale&&Be&&Qe){let bt=pe,wt=Ne,ot=_e,qe=Ie;if(I.ori==1&&(bt=_e,wt=Ie,ot=pe,qe=Ne),gi&&ua(b,Lr(bt,b),Lr(bt+wt,b)),_i)for(let Ge in P){let Gt=P[Ge];Ge!=b&&Gt.from==null&&Gt.min!=It&&ua(Ge,Lr(ot+qe,Ge),Lr(ot,Ge))}Ll()}else se.lock&&(se._lock=!se._lock,Ua(S,!0,g!=null));g!=null&&(V(Gl,ql),ls(Gl,n,zt,Wt,ve,ae,null))}function Km(g,S,C,D,H,$,oe){if(se._lock)return;He(g);let pe=ca;if(ca){let _e=!0,Ne=!0,Ie=10,Be,Qe;I.ori==0?(Be=gi,Qe=_i):(Be=_i,Qe=gi),Be&&Qe&&(_e=zt<=Ie||zt>=ve-Ie,Ne=Wt<=Ie||Wt>=ae-Ie),Be&&_e&&(zt=zt<hn?0:ve),Qe&&Ne&&(Wt=Wt<cn?0:ae),Ua(null,!0,!0),ca=!1}zt=-10,Wt=-10,K.fill(null),Ua(null,!0,!0),pe&&(ca=pe)}function Mu(g,S,C,D,H,$,oe){se._lock||(He(g),nn(),Ll(),g!=null&&ls($u,n,zt,Wt,ve,ae,null))}function Su(){a()}Ga(ro,vn,Su);let fn={};fn.mousedown=vu,fn.mousemove=fu,fn.mouseup=xu,fn.dblclick=Mu,fn.setSeries=(g,S,C,D)=>{let H=ai.match[2];C=H(n,S,C),C!=-1&&Pr(C,D,!0,!1)},Re&&(kt(Xu,p,vu),kt(Hl,p,fu),kt(Yu,p,g=>{He(g),os(!1)}),kt(qu,p,Km),kt($u,p,Mu),ih.add(n),n.syncRect=os);let qs=n.hooks=e.hooks||{};function vi(g,S,C){Xi?ha.push([g,S,C]):g in qs&&qs[g].forEach(D=>{D.call(null,n,S,C)})}(e.plugins||[]).forEach(g=>{for(let S in g.hooks)qs[S]=(qs[S]||[]).concat(g.hooks[S])});let yu=(g,S,C)=>C,ai=ni({key:null,setSeries:!1,filters:{pub:Hu,sub:Hu},scales:[b,E[1]?E[1].scale:null],match:[Gu,Gu,yu],values:[null,null]},se.sync);ai.match.length==2&&ai.match.push(yu),se.sync=ai;let Eu=ai.key,Dl=Jd(Eu);function ls(g,S,C,D,H,$,oe){ai.filters.pub(g,S,C,D,H,$,oe)&&Dl.pub(g,S,C,D,H,$,oe)}Dl.sub(n);function Jm(g,S,C,D,H,$,oe){ai.filters.sub(g,S,C,D,H,$,oe)&&fn[g](null,S,C,D,H,$,oe)}n.pub=Jm;function Zm(){Dl.unsub(n),ih.delete(n),Ut.clear(),Jl(ro,vn,Su),d.remove(),Fe?.remove(),vi("destroy")}n.destroy=Zm;function Nl(){vi("init",e,t),Xs(t||e.data,!1),O[b]?wl(b,O[b]):nn(),F=Ht.show&&(Ht.width>0||Ht.height>0),ye=Q=!0,ue(e.width,e.height)}return E.forEach(is),T.forEach(js),i?i instanceof HTMLElement?(i.appendChild(d),Nl()):i(n,Nl):Nl(),n}bi.assign=ni;bi.fmtNum=sh;bi.rangeNum=io;bi.rangeLog=so;bi.rangeAsinh=ah;bi.orient=ja;bi.pxRatio=_a;bi.join=bg;bi.fmtDate=uh,bi.tzDate=i0;bi.sync=Jd;{bi.addGap=G0,bi.clipGaps=co;let e=bi.paths={points:af};e.linear=sf,e.stepped=j0,e.bars=X0,e.spline=q0}var vh=Ul.length,mo=class{constructor(t,i,r,a){this.history=i,this.seek=a,this.chosen=r.filter(n=>i.columns.has(n)).slice(0,vh),this.plots=[],this.time=null,this.place=t,t.classList.add("plots"),t.innerHTML=`
      <div class="chooser">
        <input type="search" placeholder="column of the history, for example energy" aria-label="find a column" />
        <ul class="found" hidden></ul>
        <ul class="chosen"></ul>
      </div>
      <div class="drawn"></div>`,this.input=t.querySelector("input"),this.found=t.querySelector(".found"),this.list=t.querySelector(".chosen"),this.drawn=t.querySelector(".drawn"),this.input.addEventListener("input",()=>this.offer()),this.input.addEventListener("focus",()=>this.offer()),this.input.addEventListener("keydown",n=>{n.stopPropagation(),n.key==="Escape"&&this.input.blur(),n.key==="Enter"&&this.found.querySelector("li[data-name]")?.click()}),document.addEventListener("pointerdown",n=>{t.querySelector(".chooser").contains(n.target)||(this.found.hidden=!0)}),new ResizeObserver(()=>this.resize()).observe(this.drawn),this.draw()}offer(){let t=this.input.value.toLowerCase().split(/\s+/).filter(Boolean),i=[...this.history.columns.keys()].filter(r=>r!=="time"&&t.every(a=>r.toLowerCase().includes(a)));this.found.replaceChildren(...i.slice(0,200).map(r=>{let a=document.createElement("li");return a.dataset.name=r,a.textContent=`${r} [${this.history.columns.get(r).unit}]`,a.classList.toggle("on",this.chosen.includes(r)),a.addEventListener("click",()=>this.toggle(r)),a})),i.length===0&&(this.found.innerHTML="<li>no column has these letters</li>"),this.found.hidden=!1}toggle(t){if(this.chosen.includes(t))this.chosen=this.chosen.filter(i=>i!==t);else if(this.chosen.length<vh)this.chosen.push(t);else{this.found.innerHTML=`<li>${vh} columns are shown; remove one first</li>`;return}this.draw(),this.found.hidden||this.offer()}colour(t){return Ul[this.chosen.indexOf(t)]}draw(){this.list.replaceChildren(...this.chosen.map(i=>{let r=document.createElement("li");return r.innerHTML=`<span class="dot" style="background:${this.colour(i)}"></span><span></span><output></output><button>\xD7</button>`,r.children[1].textContent=i,r.querySelector("button").setAttribute("aria-label",`remove ${i}`),r.querySelector("button").addEventListener("click",()=>this.toggle(i)),r}));for(let{plot:i,box:r}of this.plots)i.destroy(),r.remove();let t=[...new Set(this.chosen.map(i=>this.history.columns.get(i).unit))];this.plots=t.map(i=>this.plotOf(i)),this.resize(),this.showTime(this.time)}plotOf(t){let i=this.chosen.filter(f=>this.history.columns.get(f).unit===t),r=i.map(f=>this.history.columns.get(f).values),a=0;for(let f of r)for(let _ of f)a=Math.max(a,Math.abs(_));let n=kl(t,a),s="12px sans-serif",o={width:320,height:200,legend:{show:!1},cursor:{sync:{key:"footfall"},drag:{x:!0,y:!1,setScale:!0},points:{size:6}},scales:{x:{time:!1}},axes:[{font:s,labelFont:s,size:34,stroke:"#333",grid:{stroke:"#e4e4e4",width:1},values:(f,_)=>_.map(x=>zi(x))},{font:s,labelFont:s,size:58,stroke:"#333",grid:{stroke:"#e4e4e4",width:1},values:(f,_)=>_.map(x=>zi(x))}],series:[{},...i.map(f=>({label:f,stroke:this.colour(f),width:1.6,points:{show:!1}}))],hooks:{setCursor:[f=>this.showValues(f.cursor.idx)],setScale:[()=>this.showTime(this.time)]}},l=document.createElement("div");l.className="plot";let h=document.createElement("div");h.className="unit",h.textContent=n.unit?`[${n.unit}] over time [s]`:"[-] over time [s]",l.append(h),this.drawn.append(l);let c=new bi(o,[this.history.time,...r.map(f=>f.map(_=>_*n.factor))],l),d=document.createElement("div");d.className="now",c.over.append(d);let u=null;return c.over.addEventListener("pointerdown",f=>u=[f.clientX,f.clientY]),c.over.addEventListener("pointerup",f=>{u&&Math.hypot(f.clientX-u[0],f.clientY-u[1])<4&&this.seek&&this.seek(c.posToVal(f.clientX-c.over.getBoundingClientRect().left,"x"))}),{plot:c,line:d,box:l,names:i,scale:n}}showTime(t){this.time=t;for(let{plot:i,line:r}of this.plots){let a=t===null?NaN:i.valToPos(t,"x");r.hidden=!(a>=0&&a<=i.over.clientWidth),r.hidden||(r.style.transform=`translateX(${a}px)`)}this.pointed==null&&t!==null&&this.writeValues(this.rowAt(t))}showValues(t){this.pointed=t,t!=null?this.writeValues(t):this.time!==null&&this.writeValues(this.rowAt(this.time))}rowAt(t){let{time:i}=this.history,r=0,a=i.length-1;for(;r<a;){let n=r+a+1>>1;i[n]<=t?r=n:a=n-1}return r+1<i.length&&i[r+1]-t<t-i[r]?r+1:r}writeValues(t){for(let{names:i,scale:r}of this.plots)for(let a of i){let n=this.history.columns.get(a).values[t]*r.factor;this.list.children[this.chosen.indexOf(a)].querySelector("output").textContent=`${zi(n)} ${r.unit}`}}resize(){let t=this.drawn.clientWidth;if(!(t>60))return;let i=Math.max(150,Math.min(260,this.plots.length===1?260:190));for(let{plot:r}of this.plots)r.setSize({width:t,height:i});this.showTime(this.time)}};var Hn={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},zn={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},n_=0,cf=1,s_=2,Wo=1,o_=2,Ts=3,Ka=0,Vi=1,ra=2,Gn=0,Rs=1,uf=2,df=3,ff=4,l_=5,Fn=100,h_=101,c_=102,u_=103,d_=104,f_=200,p_=201,m_=202,g_=203,Sp=204,yp=205,__=206,v_=207,x_=208,M_=209,S_=210,y_=211,E_=212,b_=213,w_=214,qh=0,$h=1,Kh=2,Ls=3,Jh=4,Zh=5,Qh=6,ec=7,Ep=0,T_=1,A_=2,na=0,bp=1,wp=2,Tp=3,Ap=4,Rp=5,Cp=6,Pp=7,Lp=300,Wn=301,Ds=302,xh=303,Mh=304,tc=1e3,aa=1001,ic=1002,wi=1003,R_=1004,go=1005,Gi=1006,Sh=1007,wa=1008,hr=1009,Dp=1010,Np=1011,Ns=1012,Fc=1013,Gr=1014,Br=1015,Vr=1016,kc=1017,Bc=1018,jn=1020,Ip=35902,Up=35899,Op=1021,Fp=1022,zr=1023,Aa=1026,Ta=1027,kp=1028,zc=1029,Ja=1030,Hc=1031,Gc=1033,jo=33776,Xo=33777,Yo=33778,qo=33779,rc=35840,ac=35841,nc=35842,sc=35843,oc=36196,lc=37492,hc=37496,cc=37488,uc=37489,Qo=37490,dc=37491,fc=37808,pc=37809,mc=37810,gc=37811,_c=37812,vc=37813,xc=37814,Mc=37815,Sc=37816,yc=37817,Ec=37818,bc=37819,wc=37820,Tc=37821,Ac=36492,Rc=36494,Cc=36495,Pc=36283,Lc=36284,el=36285,Dc=36286,tl=2300,Nc=2301,yh=2302,pf=2303,mf=2400,gf=2401,_f=2402,C_=3200,vf=0,P_=1,ba="",or="srgb",il="srgb-linear",rl="linear",Pt="srgb",Eh=7680,L_=519,D_=512,N_=513,I_=514,Bp=515,U_=516,O_=517,zp=518,Hp=519,F_=35044,xf="300 es",yr=2e3,al=2001;function k_(e){for(let t=e.length-1;t>=0;--t)if(e[t]>=65535)return!0;return!1}function B_(e){return ArrayBuffer.isView(e)&&!(e instanceof DataView)}function nl(e){return document.createElementNS("http://www.w3.org/1999/xhtml",e)}function z_(){let e=nl("canvas");return e.style.display="block",e}var Mf={},Xn=null;function Sf(...e){let t="THREE."+e.shift();Xn?Xn("log",t,...e):console.log(t,...e)}function Gp(e){let t=e[0];if(typeof t=="string"&&t.startsWith("TSL:")){let i=e[1];i&&i.isStackTrace?e[0]+=" "+i.getLocation():e[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return e}function Ye(...e){e=Gp(e);let t="THREE."+e.shift();if(Xn)Xn("warn",t,...e);else{let i=e[0];i&&i.isStackTrace?console.warn(i.getError(t)):console.warn(t,...e)}}function Ze(...e){e=Gp(e);let t="THREE."+e.shift();if(Xn)Xn("error",t,...e);else{let i=e[0];i&&i.isStackTrace?console.error(i.getError(t)):console.error(t,...e)}}function $o(...e){let t=e.join(" ");t in Mf||(Mf[t]=!0,Ye(...e))}function H_(e,t,i){return new Promise(function(r,a){function n(){switch(e.clientWaitSync(t,e.SYNC_FLUSH_COMMANDS_BIT,0)){case e.WAIT_FAILED:a();break;case e.TIMEOUT_EXPIRED:setTimeout(n,i);break;default:r()}}setTimeout(n,i)})}var G_={[qh]:qh,[Kh]:Qh,[Jh]:Jh,[Ls]:Zh,[$h]:$h,[Qh]:Kh,[ec]:ec,[Zh]:Ls},Ra=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let r=i[e];if(r!==void 0){let a=r.indexOf(t);a!==-1&&r.splice(a,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let r=i.slice(0);for(let a=0,n=r.length;a<n;a++)r[a].call(this,e);e.target=null}}},Pi=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],yf=1234567,Cs=Math.PI/180,Is=180/Math.PI;function $n(){let e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0,r=Math.random()*4294967295|0;return(Pi[e&255]+Pi[e>>8&255]+Pi[e>>16&255]+Pi[e>>24&255]+"-"+Pi[t&255]+Pi[t>>8&255]+"-"+Pi[t>>16&15|64]+Pi[t>>24&255]+"-"+Pi[i&63|128]+Pi[i>>8&255]+"-"+Pi[i>>16&255]+Pi[i>>24&255]+Pi[r&255]+Pi[r>>8&255]+Pi[r>>16&255]+Pi[r>>24&255]).toLowerCase()}function st(e,t,i){return Math.max(t,Math.min(i,e))}function Vc(e,t){return(e%t+t)%t}function V_(e,t,i,r,a){return r+(e-t)*(a-r)/(i-t)}function W_(e,t,i){return e!==t?(i-e)/(t-e):0}function Ps(e,t,i){return(1-i)*e+i*t}function j_(e,t,i,r){return Ps(e,t,1-Math.exp(-i*r))}function X_(e,t=1){return t-Math.abs(Vc(e,t*2)-t)}function Y_(e,t,i){return e<=t?0:e>=i?1:(e=(e-t)/(i-t),e*e*(3-2*e))}function q_(e,t,i){return e<=t?0:e>=i?1:(e=(e-t)/(i-t),e*e*e*(e*(e*6-15)+10))}function $_(e,t){return e+Math.floor(Math.random()*(t-e+1))}function K_(e,t){return e+Math.random()*(t-e)}function J_(e){return e*(.5-Math.random())}function Z_(e){e!==void 0&&(yf=e);let t=yf+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Q_(e){return e*Cs}function ev(e){return e*Is}function tv(e){return e>0&&Number.isInteger(e)&&2**Math.round(Math.log2(e))===e}function iv(e){return Math.pow(2,Math.ceil(Math.log(e)/Math.LN2))}function Vp(e){return Math.pow(2,Math.floor(Math.log(e)/Math.LN2))}function rv(e,t,i,r,a){let n=Math.cos,s=Math.sin,o=n(i/2),l=s(i/2),h=n((t+r)/2),c=s((t+r)/2),d=n((t-r)/2),u=s((t-r)/2),f=n((r-t)/2),_=s((r-t)/2);switch(a){case"XYX":e.set(o*c,l*d,l*u,o*h);break;case"YZY":e.set(l*u,o*c,l*d,o*h);break;case"ZXZ":e.set(l*d,l*u,o*c,o*h);break;case"XZX":e.set(o*c,l*_,l*f,o*h);break;case"YXY":e.set(l*f,o*c,l*_,o*h);break;case"ZYZ":e.set(l*_,l*f,o*c,o*h);break;default:Ye("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+a)}}function Wc(e){switch(e.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Wp(e,t){if(t.constructor===Float32Array)return e;let i=Wc(t);if(i===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(e/i,-1)}function jp(e,t){if(t.constructor===Float32Array)return e;let i=Wc(t);if(i===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(e*i)}var av={DEG2RAD:Cs,RAD2DEG:Is,generateUUID:$n,clamp:st,euclideanModulo:Vc,mapLinear:V_,inverseLerp:W_,lerp:Ps,damp:j_,pingpong:X_,smoothstep:Y_,smootherstep:q_,randInt:$_,randFloat:K_,randFloatSpread:J_,seededRandom:Z_,degToRad:Q_,radToDeg:ev,isPowerOfTwo:tv,ceilPowerOfTwo:iv,floorPowerOfTwo:Vp,setQuaternionFromProperEuler:rv,normalize:jp,denormalize:Wp},rt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6],this.y=r[1]*t+r[4]*i+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=st(this.x,e.x,t.x),this.y=st(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=st(this.x,e,t),this.y=st(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(st(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(st(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),r=Math.sin(t),a=this.x-e.x,n=this.y-e.y;return this.x=a*i-n*r+e.x,this.y=a*r+n*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Er=class{constructor(e=0,t=0,i=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=r}static slerpFlat(e,t,i,r,a,n,s){let o=i[r+0],l=i[r+1],h=i[r+2],c=i[r+3],d=a[n+0],u=a[n+1],f=a[n+2],_=a[n+3];if(c!==_||o!==d||l!==u||h!==f){let x=o*d+l*u+h*f+c*_;x<0&&(d=-d,u=-u,f=-f,_=-_,x=-x);let p=1-s;if(x<.9995){let m=Math.acos(x),w=Math.sin(m);p=Math.sin(p*m)/w,s=Math.sin(s*m)/w,o=o*p+d*s,l=l*p+u*s,h=h*p+f*s,c=c*p+_*s}else{o=o*p+d*s,l=l*p+u*s,h=h*p+f*s,c=c*p+_*s;let m=1/Math.sqrt(o*o+l*l+h*h+c*c);o*=m,l*=m,h*=m,c*=m}}e[t]=o,e[t+1]=l,e[t+2]=h,e[t+3]=c}static multiplyQuaternionsFlat(e,t,i,r,a,n){let s=i[r],o=i[r+1],l=i[r+2],h=i[r+3],c=a[n],d=a[n+1],u=a[n+2],f=a[n+3];return e[t]=s*f+h*c+o*u-l*d,e[t+1]=o*f+h*d+l*c-s*u,e[t+2]=l*f+h*u+s*d-o*c,e[t+3]=h*f-s*c-o*d-l*u,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,r){return this._x=e,this._y=t,this._z=i,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,r=e._y,a=e._z,n=e._order,s=Math.cos,o=Math.sin,l=s(i/2),h=s(r/2),c=s(a/2),d=o(i/2),u=o(r/2),f=o(a/2);switch(n){case"XYZ":this._x=d*h*c+l*u*f,this._y=l*u*c-d*h*f,this._z=l*h*f+d*u*c,this._w=l*h*c-d*u*f;break;case"YXZ":this._x=d*h*c+l*u*f,this._y=l*u*c-d*h*f,this._z=l*h*f-d*u*c,this._w=l*h*c+d*u*f;break;case"ZXY":this._x=d*h*c-l*u*f,this._y=l*u*c+d*h*f,this._z=l*h*f+d*u*c,this._w=l*h*c-d*u*f;break;case"ZYX":this._x=d*h*c-l*u*f,this._y=l*u*c+d*h*f,this._z=l*h*f-d*u*c,this._w=l*h*c+d*u*f;break;case"YZX":this._x=d*h*c+l*u*f,this._y=l*u*c+d*h*f,this._z=l*h*f-d*u*c,this._w=l*h*c-d*u*f;break;case"XZY":this._x=d*h*c-l*u*f,this._y=l*u*c-d*h*f,this._z=l*h*f+d*u*c,this._w=l*h*c+d*u*f;break;default:Ye("Quaternion: .setFromEuler() encountered an unknown order: "+n)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,r=Math.sin(i);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],r=t[4],a=t[8],n=t[1],s=t[5],o=t[9],l=t[2],h=t[6],c=t[10],d=i+s+c;if(d>0){let u=.5/Math.sqrt(d+1);this._w=.25/u,this._x=(h-o)*u,this._y=(a-l)*u,this._z=(n-r)*u}else if(i>s&&i>c){let u=2*Math.sqrt(1+i-s-c);this._w=(h-o)/u,this._x=.25*u,this._y=(r+n)/u,this._z=(a+l)/u}else if(s>c){let u=2*Math.sqrt(1+s-i-c);this._w=(a-l)/u,this._x=(r+n)/u,this._y=.25*u,this._z=(o+h)/u}else{let u=2*Math.sqrt(1+c-i-s);this._w=(n-r)/u,this._x=(a+l)/u,this._y=(o+h)/u,this._z=.25*u}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(st(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let r=Math.min(1,t/i);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,r=e._y,a=e._z,n=e._w,s=t._x,o=t._y,l=t._z,h=t._w;return this._x=i*h+n*s+r*l-a*o,this._y=r*h+n*o+a*s-i*l,this._z=a*h+n*l+i*o-r*s,this._w=n*h-i*s-r*o-a*l,this._onChangeCallback(),this}slerp(e,t){let i=e._x,r=e._y,a=e._z,n=e._w,s=this.dot(e);s<0&&(i=-i,r=-r,a=-a,n=-n,s=-s);let o=1-t;if(s<.9995){let l=Math.acos(s),h=Math.sin(l);o=Math.sin(o*l)/h,t=Math.sin(t*l)/h,this._x=this._x*o+i*t,this._y=this._y*o+r*t,this._z=this._z*o+a*t,this._w=this._w*o+n*t,this._onChangeCallback()}else this._x=this._x*o+i*t,this._y=this._y*o+r*t,this._z=this._z*o+a*t,this._w=this._w*o+n*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),r=Math.sqrt(1-i),a=Math.sqrt(i);return this.set(r*Math.sin(e),r*Math.cos(e),a*Math.sin(t),a*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},X=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Ef.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Ef.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,r=this.z,a=e.elements;return this.x=a[0]*t+a[3]*i+a[6]*r,this.y=a[1]*t+a[4]*i+a[7]*r,this.z=a[2]*t+a[5]*i+a[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,a=e.elements,n=1/(a[3]*t+a[7]*i+a[11]*r+a[15]);return this.x=(a[0]*t+a[4]*i+a[8]*r+a[12])*n,this.y=(a[1]*t+a[5]*i+a[9]*r+a[13])*n,this.z=(a[2]*t+a[6]*i+a[10]*r+a[14])*n,this}applyQuaternion(e){let t=this.x,i=this.y,r=this.z,a=e.x,n=e.y,s=e.z,o=e.w,l=2*(n*r-s*i),h=2*(s*t-a*r),c=2*(a*i-n*t);return this.x=t+o*l+n*c-s*h,this.y=i+o*h+s*l-a*c,this.z=r+o*c+a*h-n*l,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,r=this.z,a=e.elements;return this.x=a[0]*t+a[4]*i+a[8]*r,this.y=a[1]*t+a[5]*i+a[9]*r,this.z=a[2]*t+a[6]*i+a[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=st(this.x,e.x,t.x),this.y=st(this.y,e.y,t.y),this.z=st(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=st(this.x,e,t),this.y=st(this.y,e,t),this.z=st(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(st(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,r=e.y,a=e.z,n=t.x,s=t.y,o=t.z;return this.x=r*o-a*s,this.y=a*n-i*o,this.z=i*s-r*n,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return bh.copy(this).projectOnVector(e),this.sub(bh)}reflect(e){return this.sub(bh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(st(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,r=this.z-e.z;return t*t+i*i+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let r=Math.sin(t)*e;return this.x=r*Math.sin(i),this.y=Math.cos(t)*e,this.z=r*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},bh=new X,Ef=new Er,et=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,r,a,n,s,o,l){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,r,a,n,s,o,l)}set(e,t,i,r,a,n,s,o,l){let h=this.elements;return h[0]=e,h[1]=r,h[2]=s,h[3]=t,h[4]=a,h[5]=o,h[6]=i,h[7]=n,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,a=this.elements,n=i[0],s=i[3],o=i[6],l=i[1],h=i[4],c=i[7],d=i[2],u=i[5],f=i[8],_=r[0],x=r[3],p=r[6],m=r[1],w=r[4],R=r[7],E=r[2],T=r[5],P=r[8];return a[0]=n*_+s*m+o*E,a[3]=n*x+s*w+o*T,a[6]=n*p+s*R+o*P,a[1]=l*_+h*m+c*E,a[4]=l*x+h*w+c*T,a[7]=l*p+h*R+c*P,a[2]=d*_+u*m+f*E,a[5]=d*x+u*w+f*T,a[8]=d*p+u*R+f*P,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],r=e[2],a=e[3],n=e[4],s=e[5],o=e[6],l=e[7],h=e[8];return t*n*h-t*s*l-i*a*h+i*s*o+r*a*l-r*n*o}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],a=e[3],n=e[4],s=e[5],o=e[6],l=e[7],h=e[8],c=h*n-s*l,d=s*o-h*a,u=l*a-n*o,f=t*c+i*d+r*u;if(f===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/f;return e[0]=c*_,e[1]=(r*l-h*i)*_,e[2]=(s*i-r*n)*_,e[3]=d*_,e[4]=(h*t-r*o)*_,e[5]=(r*a-s*t)*_,e[6]=u*_,e[7]=(i*o-l*t)*_,e[8]=(n*t-i*a)*_,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,r,a,n,s){let o=Math.cos(a),l=Math.sin(a);return this.set(i*o,i*l,-i*(o*n+l*s)+n+e,-r*l,r*o,-r*(-l*n+o*s)+s+t,0,0,1),this}scale(e,t){return $o("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(wh.makeScale(e,t)),this}rotate(e){return $o("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(wh.makeRotation(-e)),this}translate(e,t){return $o("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(wh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<9;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},wh=new et,bf=new et().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),wf=new et().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function nv(){let e={enabled:!0,workingColorSpace:il,spaces:{},convert:function(a,n,s){return this.enabled===!1||n===s||!n||!s||(this.spaces[n].transfer===Pt&&(a.r=sa(a.r),a.g=sa(a.g),a.b=sa(a.b)),this.spaces[n].primaries!==this.spaces[s].primaries&&(a.applyMatrix3(this.spaces[n].toXYZ),a.applyMatrix3(this.spaces[s].fromXYZ)),this.spaces[s].transfer===Pt&&(a.r=Vn(a.r),a.g=Vn(a.g),a.b=Vn(a.b))),a},workingToColorSpace:function(a,n){return this.convert(a,this.workingColorSpace,n)},colorSpaceToWorking:function(a,n){return this.convert(a,n,this.workingColorSpace)},getPrimaries:function(a){return this.spaces[a].primaries},getTransfer:function(a){return a===ba?rl:this.spaces[a].transfer},getToneMappingMode:function(a){return this.spaces[a].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(a,n=this.workingColorSpace){return a.fromArray(this.spaces[n].luminanceCoefficients)},define:function(a){Object.assign(this.spaces,a)},_getMatrix:function(a,n,s){return a.copy(this.spaces[s].fromXYZ).multiply(this.spaces[n].toXYZ)},_getDrawingBufferColorSpace:function(a){return this.spaces[a].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(a=this.workingColorSpace){return this.spaces[a].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],i=[.2126,.7152,.0722],r=[.3127,.329];return e.define({[il]:{primaries:t,whitePoint:r,transfer:rl,toXYZ:bf,fromXYZ:wf,luminanceCoefficients:i,workingColorSpaceConfig:{unpackColorSpace:or},outputColorSpaceConfig:{drawingBufferColorSpace:or}},[or]:{primaries:t,whitePoint:r,transfer:Pt,toXYZ:bf,fromXYZ:wf,luminanceCoefficients:i,outputColorSpaceConfig:{drawingBufferColorSpace:or}}}),e}var ft=nv();function sa(e){return e<.04045?e*.0773993808:Math.pow(e*.9478672986+.0521327014,2.4)}function Vn(e){return e<.0031308?e*12.92:1.055*Math.pow(e,.41666)-.055}var bn,sv=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{bn===void 0&&(bn=nl("canvas")),bn.width=e.width,bn.height=e.height;let r=bn.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),i=bn}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=nl("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let r=i.getImageData(0,0,e.width,e.height),a=r.data;for(let n=0;n<a.length;n++)a[n]=sa(a[n]/255)*255;return i.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(sa(t[i]/255)*255):t[i]=sa(t[i]);return{data:t,width:e.width,height:e.height}}else return Ye("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},ov=0,jc=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:ov++}),this.uuid=$n(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},r=this.data;if(r!==null){let a;if(Array.isArray(r)){a=[];for(let n=0,s=r.length;n<s;n++)r[n].isDataTexture?a.push(Th(r[n].image)):a.push(Th(r[n]))}else a=Th(r);i.url=a}return t||(e.images[this.uuid]=i),i}};function Th(e){return typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap?sv.getDataURL(e):e.data?{data:Array.from(e.data),width:e.width,height:e.height,type:e.data.constructor.name}:(Ye("Texture: Unable to serialize Texture."),{})}var lv=0,Ah=new X,br=class Ko extends Ra{constructor(t=Ko.DEFAULT_IMAGE,i=Ko.DEFAULT_MAPPING,r=aa,a=aa,n=Gi,s=wa,o=zr,l=hr,h=Ko.DEFAULT_ANISOTROPY,c=ba){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:lv++}),this.uuid=$n(),this.name="",this.source=new jc(t),this.mipmaps=[],this.mapping=i,this.channel=0,this.wrapS=r,this.wrapT=a,this.magFilter=n,this.minFilter=s,this.anisotropy=h,this.format=o,this.internalFormat=null,this.type=l,this.offset=new rt(0,0),this.repeat=new rt(1,1),this.center=new rt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new et,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=c,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Ah).x}get height(){return this.source.getSize(Ah).y}get depth(){return this.source.getSize(Ah).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,i){this.updateRanges.push({start:t,count:i})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let i in t){let r=t[i];if(r===void 0){Ye(`Texture.setValues(): parameter '${i}' has value of undefined.`);continue}let a=this[i];if(a===void 0){Ye(`Texture.setValues(): property '${i}' does not exist.`);continue}a&&r&&a.isVector2&&r.isVector2||a&&r&&a.isVector3&&r.isVector3||a&&r&&a.isMatrix3&&r.isMatrix3?a.copy(r):this[i]=r}}toJSON(t){let i=t===void 0||typeof t=="string";if(!i&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let r={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(r.userData=this.userData),i||(t.textures[this.uuid]=r),r}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Lp)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case tc:t.x=t.x-Math.floor(t.x);break;case aa:t.x=t.x<0?0:1;break;case ic:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case tc:t.y=t.y-Math.floor(t.y);break;case aa:t.y=t.y<0?0:1;break;case ic:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};br.DEFAULT_IMAGE=null;br.DEFAULT_MAPPING=Lp;br.DEFAULT_ANISOTROPY=1;var Ft=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,r=1){this.x=e,this.y=t,this.z=i,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,r){return this.x=e,this.y=t,this.z=i,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,a=this.w,n=e.elements;return this.x=n[0]*t+n[4]*i+n[8]*r+n[12]*a,this.y=n[1]*t+n[5]*i+n[9]*r+n[13]*a,this.z=n[2]*t+n[6]*i+n[10]*r+n[14]*a,this.w=n[3]*t+n[7]*i+n[11]*r+n[15]*a,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,r,a,n=e.elements,s=n[0],o=n[4],l=n[8],h=n[1],c=n[5],d=n[9],u=n[2],f=n[6],_=n[10];if(Math.abs(o-h)<.01&&Math.abs(l-u)<.01&&Math.abs(d-f)<.01){if(Math.abs(o+h)<.1&&Math.abs(l+u)<.1&&Math.abs(d+f)<.1&&Math.abs(s+c+_-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let p=(s+1)/2,m=(c+1)/2,w=(_+1)/2,R=(o+h)/4,E=(l+u)/4,T=(d+f)/4;return p>m&&p>w?p<.01?(i=0,r=.707106781,a=.707106781):(i=Math.sqrt(p),r=R/i,a=E/i):m>w?m<.01?(i=.707106781,r=0,a=.707106781):(r=Math.sqrt(m),i=R/r,a=T/r):w<.01?(i=.707106781,r=.707106781,a=0):(a=Math.sqrt(w),i=E/a,r=T/a),this.set(i,r,a,t),this}let x=Math.sqrt((f-d)*(f-d)+(l-u)*(l-u)+(h-o)*(h-o));return Math.abs(x)<.001&&(x=1),this.x=(f-d)/x,this.y=(l-u)/x,this.z=(h-o)/x,this.w=Math.acos((s+c+_-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=st(this.x,e.x,t.x),this.y=st(this.y,e.y,t.y),this.z=st(this.z,e.z,t.z),this.w=st(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=st(this.x,e,t),this.y=st(this.y,e,t),this.z=st(this.z,e,t),this.w=st(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(st(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},hv=class extends Ra{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Gi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Ft(0,0,e,t),this.scissorTest=!1,this.viewport=new Ft(0,0,e,t),this.textures=[];let r=i.count;for(let a=0;a<r;a++)this.textures[a]=new br({width:e,height:t,depth:i.depth}),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Gi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let r=0,a=this.textures.length;r<a;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=i,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new jc(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Hr=class extends hv{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Xp=class extends br{constructor(e=null,t=1,i=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=wi,this.minFilter=wi,this.wrapR=aa,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}},cv=class extends br{constructor(e=null,t=1,i=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=wi,this.minFilter=wi,this.wrapR=aa,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}},ti=class Yp{static{this.prototype.isMatrix4=!0}constructor(t,i,r,a,n,s,o,l,h,c,d,u,f,_,x,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,i,r,a,n,s,o,l,h,c,d,u,f,_,x,p)}set(t,i,r,a,n,s,o,l,h,c,d,u,f,_,x,p){let m=this.elements;return m[0]=t,m[4]=i,m[8]=r,m[12]=a,m[1]=n,m[5]=s,m[9]=o,m[13]=l,m[2]=h,m[6]=c,m[10]=d,m[14]=u,m[3]=f,m[7]=_,m[11]=x,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Yp().fromArray(this.elements)}copy(t){let i=this.elements,r=t.elements;return i[0]=r[0],i[1]=r[1],i[2]=r[2],i[3]=r[3],i[4]=r[4],i[5]=r[5],i[6]=r[6],i[7]=r[7],i[8]=r[8],i[9]=r[9],i[10]=r[10],i[11]=r[11],i[12]=r[12],i[13]=r[13],i[14]=r[14],i[15]=r[15],this}copyPosition(t){let i=this.elements,r=t.elements;return i[12]=r[12],i[13]=r[13],i[14]=r[14],this}setFromMatrix3(t){let i=t.elements;return this.set(i[0],i[3],i[6],0,i[1],i[4],i[7],0,i[2],i[5],i[8],0,0,0,0,1),this}extractBasis(t,i,r){return this.determinantAffine()===0?(t.set(1,0,0),i.set(0,1,0),r.set(0,0,1),this):(t.setFromMatrixColumn(this,0),i.setFromMatrixColumn(this,1),r.setFromMatrixColumn(this,2),this)}makeBasis(t,i,r){return this.set(t.x,i.x,r.x,0,t.y,i.y,r.y,0,t.z,i.z,r.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let i=this.elements,r=t.elements,a=1/wn.setFromMatrixColumn(t,0).length(),n=1/wn.setFromMatrixColumn(t,1).length(),s=1/wn.setFromMatrixColumn(t,2).length();return i[0]=r[0]*a,i[1]=r[1]*a,i[2]=r[2]*a,i[3]=0,i[4]=r[4]*n,i[5]=r[5]*n,i[6]=r[6]*n,i[7]=0,i[8]=r[8]*s,i[9]=r[9]*s,i[10]=r[10]*s,i[11]=0,i[12]=0,i[13]=0,i[14]=0,i[15]=1,this}makeRotationFromEuler(t){let i=this.elements,r=t.x,a=t.y,n=t.z,s=Math.cos(r),o=Math.sin(r),l=Math.cos(a),h=Math.sin(a),c=Math.cos(n),d=Math.sin(n);if(t.order==="XYZ"){let u=s*c,f=s*d,_=o*c,x=o*d;i[0]=l*c,i[4]=-l*d,i[8]=h,i[1]=f+_*h,i[5]=u-x*h,i[9]=-o*l,i[2]=x-u*h,i[6]=_+f*h,i[10]=s*l}else if(t.order==="YXZ"){let u=l*c,f=l*d,_=h*c,x=h*d;i[0]=u+x*o,i[4]=_*o-f,i[8]=s*h,i[1]=s*d,i[5]=s*c,i[9]=-o,i[2]=f*o-_,i[6]=x+u*o,i[10]=s*l}else if(t.order==="ZXY"){let u=l*c,f=l*d,_=h*c,x=h*d;i[0]=u-x*o,i[4]=-s*d,i[8]=_+f*o,i[1]=f+_*o,i[5]=s*c,i[9]=x-u*o,i[2]=-s*h,i[6]=o,i[10]=s*l}else if(t.order==="ZYX"){let u=s*c,f=s*d,_=o*c,x=o*d;i[0]=l*c,i[4]=_*h-f,i[8]=u*h+x,i[1]=l*d,i[5]=x*h+u,i[9]=f*h-_,i[2]=-h,i[6]=o*l,i[10]=s*l}else if(t.order==="YZX"){let u=s*l,f=s*h,_=o*l,x=o*h;i[0]=l*c,i[4]=x-u*d,i[8]=_*d+f,i[1]=d,i[5]=s*c,i[9]=-o*c,i[2]=-h*c,i[6]=f*d+_,i[10]=u-x*d}else if(t.order==="XZY"){let u=s*l,f=s*h,_=o*l,x=o*h;i[0]=l*c,i[4]=-d,i[8]=h*c,i[1]=u*d+x,i[5]=s*c,i[9]=f*d-_,i[2]=_*d-f,i[6]=o*c,i[10]=x*d+u}return i[3]=0,i[7]=0,i[11]=0,i[12]=0,i[13]=0,i[14]=0,i[15]=1,this}makeRotationFromQuaternion(t){return this.compose(uv,t,dv)}lookAt(t,i,r){let a=this.elements;return Qi.subVectors(t,i),Qi.lengthSq()===0&&(Qi.z=1),Qi.normalize(),xa.crossVectors(r,Qi),xa.lengthSq()===0&&(Math.abs(r.z)===1?Qi.x+=1e-4:Qi.z+=1e-4,Qi.normalize(),xa.crossVectors(r,Qi)),xa.normalize(),_o.crossVectors(Qi,xa),a[0]=xa.x,a[4]=_o.x,a[8]=Qi.x,a[1]=xa.y,a[5]=_o.y,a[9]=Qi.y,a[2]=xa.z,a[6]=_o.z,a[10]=Qi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,i){let r=t.elements,a=i.elements,n=this.elements,s=r[0],o=r[4],l=r[8],h=r[12],c=r[1],d=r[5],u=r[9],f=r[13],_=r[2],x=r[6],p=r[10],m=r[14],w=r[3],R=r[7],E=r[11],T=r[15],P=a[0],v=a[4],b=a[8],U=a[12],W=a[1],N=a[5],B=a[9],I=a[13],L=a[2],G=a[6],Z=a[10],O=a[14],de=a[3],J=a[7],te=a[11],ne=a[15];return n[0]=s*P+o*W+l*L+h*de,n[4]=s*v+o*N+l*G+h*J,n[8]=s*b+o*B+l*Z+h*te,n[12]=s*U+o*I+l*O+h*ne,n[1]=c*P+d*W+u*L+f*de,n[5]=c*v+d*N+u*G+f*J,n[9]=c*b+d*B+u*Z+f*te,n[13]=c*U+d*I+u*O+f*ne,n[2]=_*P+x*W+p*L+m*de,n[6]=_*v+x*N+p*G+m*J,n[10]=_*b+x*B+p*Z+m*te,n[14]=_*U+x*I+p*O+m*ne,n[3]=w*P+R*W+E*L+T*de,n[7]=w*v+R*N+E*G+T*J,n[11]=w*b+R*B+E*Z+T*te,n[15]=w*U+R*I+E*O+T*ne,this}multiplyScalar(t){let i=this.elements;return i[0]*=t,i[4]*=t,i[8]*=t,i[12]*=t,i[1]*=t,i[5]*=t,i[9]*=t,i[13]*=t,i[2]*=t,i[6]*=t,i[10]*=t,i[14]*=t,i[3]*=t,i[7]*=t,i[11]*=t,i[15]*=t,this}determinant(){let t=this.elements,i=t[0],r=t[4],a=t[8],n=t[12],s=t[1],o=t[5],l=t[9],h=t[13],c=t[2],d=t[6],u=t[10],f=t[14],_=t[3],x=t[7],p=t[11],m=t[15],w=l*f-h*u,R=o*f-h*d,E=o*u-l*d,T=s*f-h*c,P=s*u-l*c,v=s*d-o*c;return i*(x*w-p*R+m*E)-r*(_*w-p*T+m*P)+a*(_*R-x*T+m*v)-n*(_*E-x*P+p*v)}determinantAffine(){let t=this.elements,i=t[0],r=t[4],a=t[8],n=t[1],s=t[5],o=t[9],l=t[2],h=t[6],c=t[10];return i*(s*c-o*h)-r*(n*c-o*l)+a*(n*h-s*l)}transpose(){let t=this.elements,i;return i=t[1],t[1]=t[4],t[4]=i,i=t[2],t[2]=t[8],t[8]=i,i=t[6],t[6]=t[9],t[9]=i,i=t[3],t[3]=t[12],t[12]=i,i=t[7],t[7]=t[13],t[13]=i,i=t[11],t[11]=t[14],t[14]=i,this}setPosition(t,i,r){let a=this.elements;return t.isVector3?(a[12]=t.x,a[13]=t.y,a[14]=t.z):(a[12]=t,a[13]=i,a[14]=r),this}invert(){let t=this.elements,i=t[0],r=t[1],a=t[2],n=t[3],s=t[4],o=t[5],l=t[6],h=t[7],c=t[8],d=t[9],u=t[10],f=t[11],_=t[12],x=t[13],p=t[14],m=t[15],w=i*o-r*s,R=i*l-a*s,E=i*h-n*s,T=r*l-a*o,P=r*h-n*o,v=a*h-n*l,b=c*x-d*_,U=c*p-u*_,W=c*m-f*_,N=d*p-u*x,B=d*m-f*x,I=u*m-f*p,L=w*I-R*B+E*N+T*W-P*U+v*b;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/L;return t[0]=(o*I-l*B+h*N)*G,t[1]=(a*B-r*I-n*N)*G,t[2]=(x*v-p*P+m*T)*G,t[3]=(u*P-d*v-f*T)*G,t[4]=(l*W-s*I-h*U)*G,t[5]=(i*I-a*W+n*U)*G,t[6]=(p*E-_*v-m*R)*G,t[7]=(c*v-u*E+f*R)*G,t[8]=(s*B-o*W+h*b)*G,t[9]=(r*W-i*B-n*b)*G,t[10]=(_*P-x*E+m*w)*G,t[11]=(d*E-c*P-f*w)*G,t[12]=(o*U-s*N-l*b)*G,t[13]=(i*N-r*U+a*b)*G,t[14]=(x*R-_*T-p*w)*G,t[15]=(c*T-d*R+u*w)*G,this}scale(t){let i=this.elements,r=t.x,a=t.y,n=t.z;return i[0]*=r,i[4]*=a,i[8]*=n,i[1]*=r,i[5]*=a,i[9]*=n,i[2]*=r,i[6]*=a,i[10]*=n,i[3]*=r,i[7]*=a,i[11]*=n,this}getMaxScaleOnAxis(){let t=this.elements,i=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],r=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],a=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(i,r,a))}makeTranslation(t,i,r){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,i,0,0,1,r,0,0,0,1),this}makeRotationX(t){let i=Math.cos(t),r=Math.sin(t);return this.set(1,0,0,0,0,i,-r,0,0,r,i,0,0,0,0,1),this}makeRotationY(t){let i=Math.cos(t),r=Math.sin(t);return this.set(i,0,r,0,0,1,0,0,-r,0,i,0,0,0,0,1),this}makeRotationZ(t){let i=Math.cos(t),r=Math.sin(t);return this.set(i,-r,0,0,r,i,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,i){let r=Math.cos(i),a=Math.sin(i),n=1-r,s=t.x,o=t.y,l=t.z,h=n*s,c=n*o;return this.set(h*s+r,h*o-a*l,h*l+a*o,0,h*o+a*l,c*o+r,c*l-a*s,0,h*l-a*o,c*l+a*s,n*l*l+r,0,0,0,0,1),this}makeScale(t,i,r){return this.set(t,0,0,0,0,i,0,0,0,0,r,0,0,0,0,1),this}makeShear(t,i,r,a,n,s){return this.set(1,r,n,0,t,1,s,0,i,a,1,0,0,0,0,1),this}compose(t,i,r){let a=this.elements,n=i._x,s=i._y,o=i._z,l=i._w,h=n+n,c=s+s,d=o+o,u=n*h,f=n*c,_=n*d,x=s*c,p=s*d,m=o*d,w=l*h,R=l*c,E=l*d,T=r.x,P=r.y,v=r.z;return a[0]=(1-(x+m))*T,a[1]=(f+E)*T,a[2]=(_-R)*T,a[3]=0,a[4]=(f-E)*P,a[5]=(1-(u+m))*P,a[6]=(p+w)*P,a[7]=0,a[8]=(_+R)*v,a[9]=(p-w)*v,a[10]=(1-(u+x))*v,a[11]=0,a[12]=t.x,a[13]=t.y,a[14]=t.z,a[15]=1,this}decompose(t,i,r){let a=this.elements;t.x=a[12],t.y=a[13],t.z=a[14];let n=this.determinantAffine();if(n===0)return r.set(1,1,1),i.identity(),this;let s=wn.set(a[0],a[1],a[2]).length(),o=wn.set(a[4],a[5],a[6]).length(),l=wn.set(a[8],a[9],a[10]).length();n<0&&(s=-s),xr.copy(this);let h=1/s,c=1/o,d=1/l;return xr.elements[0]*=h,xr.elements[1]*=h,xr.elements[2]*=h,xr.elements[4]*=c,xr.elements[5]*=c,xr.elements[6]*=c,xr.elements[8]*=d,xr.elements[9]*=d,xr.elements[10]*=d,i.setFromRotationMatrix(xr),r.x=s,r.y=o,r.z=l,this}makePerspective(t,i,r,a,n,s,o=yr,l=!1){let h=this.elements,c=2*n/(i-t),d=2*n/(r-a),u=(i+t)/(i-t),f=(r+a)/(r-a),_,x;if(l)_=n/(s-n),x=s*n/(s-n);else if(o===yr)_=-(s+n)/(s-n),x=-2*s*n/(s-n);else if(o===al)_=-s/(s-n),x=-s*n/(s-n);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return h[0]=c,h[4]=0,h[8]=u,h[12]=0,h[1]=0,h[5]=d,h[9]=f,h[13]=0,h[2]=0,h[6]=0,h[10]=_,h[14]=x,h[3]=0,h[7]=0,h[11]=-1,h[15]=0,this}makeOrthographic(t,i,r,a,n,s,o=yr,l=!1){let h=this.elements,c=2/(i-t),d=2/(r-a),u=-(i+t)/(i-t),f=-(r+a)/(r-a),_,x;if(l)_=1/(s-n),x=s/(s-n);else if(o===yr)_=-2/(s-n),x=-(s+n)/(s-n);else if(o===al)_=-1/(s-n),x=-n/(s-n);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return h[0]=c,h[4]=0,h[8]=0,h[12]=u,h[1]=0,h[5]=d,h[9]=0,h[13]=f,h[2]=0,h[6]=0,h[10]=_,h[14]=x,h[3]=0,h[7]=0,h[11]=0,h[15]=1,this}equals(t){let i=this.elements,r=t.elements;for(let a=0;a<16;a++)if(i[a]!==r[a])return!1;return!0}fromArray(t,i=0){for(let r=0;r<16;r++)this.elements[r]=t[r+i];return this}toArray(t=[],i=0){let r=this.elements;return t[i]=r[0],t[i+1]=r[1],t[i+2]=r[2],t[i+3]=r[3],t[i+4]=r[4],t[i+5]=r[5],t[i+6]=r[6],t[i+7]=r[7],t[i+8]=r[8],t[i+9]=r[9],t[i+10]=r[10],t[i+11]=r[11],t[i+12]=r[12],t[i+13]=r[13],t[i+14]=r[14],t[i+15]=r[15],t}},wn=new X,xr=new ti,uv=new X(0,0,0),dv=new X(1,1,1),xa=new X,_o=new X,Qi=new X,Tf=new ti,Af=new Er,Us=class qp{constructor(t=0,i=0,r=0,a=qp.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=i,this._z=r,this._order=a}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,i,r,a=this._order){return this._x=t,this._y=i,this._z=r,this._order=a,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,i=this._order,r=!0){let a=t.elements,n=a[0],s=a[4],o=a[8],l=a[1],h=a[5],c=a[9],d=a[2],u=a[6],f=a[10];switch(i){case"XYZ":this._y=Math.asin(st(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-c,f),this._z=Math.atan2(-s,n)):(this._x=Math.atan2(u,h),this._z=0);break;case"YXZ":this._x=Math.asin(-st(c,-1,1)),Math.abs(c)<.9999999?(this._y=Math.atan2(o,f),this._z=Math.atan2(l,h)):(this._y=Math.atan2(-d,n),this._z=0);break;case"ZXY":this._x=Math.asin(st(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-s,h)):(this._y=0,this._z=Math.atan2(l,n));break;case"ZYX":this._y=Math.asin(-st(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(l,n)):(this._x=0,this._z=Math.atan2(-s,h));break;case"YZX":this._z=Math.asin(st(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-c,h),this._y=Math.atan2(-d,n)):(this._x=0,this._y=Math.atan2(o,f));break;case"XZY":this._z=Math.asin(-st(s,-1,1)),Math.abs(s)<.9999999?(this._x=Math.atan2(u,h),this._y=Math.atan2(o,n)):(this._x=Math.atan2(-c,f),this._y=0);break;default:Ye("Euler: .setFromRotationMatrix() encountered an unknown order: "+i)}return this._order=i,r===!0&&this._onChangeCallback(),this}setFromQuaternion(t,i,r){return Tf.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Tf,i,r)}setFromVector3(t,i=this._order){return this.set(t.x,t.y,t.z,i)}reorder(t){return Af.setFromEuler(this),this.setFromQuaternion(Af,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],i=0){return t[i]=this._x,t[i+1]=this._y,t[i+2]=this._z,t[i+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Us.DEFAULT_ORDER="XYZ";var $p=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},fv=0,Rf=new X,Tn=new Er,Jr=new ti,vo=new X,xs=new X,pv=new X,mv=new Er,Cf=new X(1,0,0),Pf=new X(0,1,0),Lf=new X(0,0,1),Df={type:"added"},gv={type:"removed"},An={type:"childadded",child:null},Rh={type:"childremoved",child:null},cr=class Jo extends Ra{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:fv++}),this.uuid=$n(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=Jo.DEFAULT_UP.clone();let t=new X,i=new Us,r=new Er,a=new X(1,1,1);function n(){r.setFromEuler(i,!1)}function s(){i.setFromQuaternion(r,void 0,!1)}i._onChange(n),r._onChange(s),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:i},quaternion:{configurable:!0,enumerable:!0,value:r},scale:{configurable:!0,enumerable:!0,value:a},modelViewMatrix:{value:new ti},normalMatrix:{value:new et}}),this.matrix=new ti,this.matrixWorld=new ti,this.matrixAutoUpdate=Jo.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=Jo.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new $p,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,i){this.quaternion.setFromAxisAngle(t,i)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,i){return Tn.setFromAxisAngle(t,i),this.quaternion.multiply(Tn),this}rotateOnWorldAxis(t,i){return Tn.setFromAxisAngle(t,i),this.quaternion.premultiply(Tn),this}rotateX(t){return this.rotateOnAxis(Cf,t)}rotateY(t){return this.rotateOnAxis(Pf,t)}rotateZ(t){return this.rotateOnAxis(Lf,t)}translateOnAxis(t,i){return Rf.copy(t).applyQuaternion(this.quaternion),this.position.add(Rf.multiplyScalar(i)),this}translateX(t){return this.translateOnAxis(Cf,t)}translateY(t){return this.translateOnAxis(Pf,t)}translateZ(t){return this.translateOnAxis(Lf,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Jr.copy(this.matrixWorld).invert())}lookAt(t,i,r){t.isVector3?vo.copy(t):vo.set(t,i,r);let a=this.parent;this.updateWorldMatrix(!0,!1),xs.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Jr.lookAt(xs,vo,this.up):Jr.lookAt(vo,xs,this.up),this.quaternion.setFromRotationMatrix(Jr),a&&(Jr.extractRotation(a.matrixWorld),Tn.setFromRotationMatrix(Jr),this.quaternion.premultiply(Tn.invert()))}add(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.add(arguments[i]);return this}return t===this?(Ze("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Df),An.child=t,this.dispatchEvent(An),An.child=null):Ze("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let r=0;r<arguments.length;r++)this.remove(arguments[r]);return this}let i=this.children.indexOf(t);return i!==-1&&(t.parent=null,this.children.splice(i,1),t.dispatchEvent(gv),Rh.child=t,this.dispatchEvent(Rh),Rh.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Jr.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Jr.multiply(t.parent.matrixWorld)),t.applyMatrix4(Jr),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Df),An.child=t,this.dispatchEvent(An),An.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,i){if(this[t]===i)return this;for(let r=0,a=this.children.length;r<a;r++){let n=this.children[r].getObjectByProperty(t,i);if(n!==void 0)return n}}getObjectsByProperty(t,i,r=[]){this[t]===i&&r.push(this);let a=this.children;for(let n=0,s=a.length;n<s;n++)a[n].getObjectsByProperty(t,i,r);return r}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(xs,t,pv),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(xs,mv,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let i=this.matrixWorld.elements;return t.set(i[8],i[9],i[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let i=this.children;for(let r=0,a=i.length;r<a;r++)i[r].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let i=this.children;for(let r=0,a=i.length;r<a;r++)i[r].traverseVisible(t)}traverseAncestors(t){let i=this.parent;i!==null&&(t(i),i.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let i=t.x,r=t.y,a=t.z,n=this.matrix.elements;n[12]+=i-n[0]*i-n[4]*r-n[8]*a,n[13]+=r-n[1]*i-n[5]*r-n[9]*a,n[14]+=a-n[2]*i-n[6]*r-n[10]*a}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let i=this.children;for(let r=0,a=i.length;r<a;r++)i[r].updateMatrixWorld(t)}updateWorldMatrix(t,i,r=!1){let a=this.parent;if(t===!0&&a!==null&&a.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||r)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,r=!0),i===!0){let n=this.children;for(let s=0,o=n.length;s<o;s++)n[s].updateWorldMatrix(!1,!0,r)}}toJSON(t){let i=t===void 0||typeof t=="string",r={};i&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},r.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let a={};a.uuid=this.uuid,a.type=this.type,a.name=this.name,a.castShadow=this.castShadow,a.receiveShadow=this.receiveShadow,a.visible=this.visible,a.frustumCulled=this.frustumCulled,a.renderOrder=this.renderOrder,a.static=this.static,a.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(a.userData=this.userData),a.layers=this.layers.mask,a.matrix=this.matrix.toArray(),a.up=this.up.toArray(),this.pivot!==null&&(a.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(a.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(a.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(a.type="InstancedMesh",a.count=this.count,a.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(a.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(a.type="BatchedMesh",a.perObjectFrustumCulled=this.perObjectFrustumCulled,a.sortObjects=this.sortObjects,a.drawRanges=this._drawRanges,a.reservedRanges=this._reservedRanges,a.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),a.instanceInfo=this._instanceInfo.map(o=>({...o})),a.availableInstanceIds=this._availableInstanceIds.slice(),a.availableGeometryIds=this._availableGeometryIds.slice(),a.nextIndexStart=this._nextIndexStart,a.nextVertexStart=this._nextVertexStart,a.geometryCount=this._geometryCount,a.maxInstanceCount=this._maxInstanceCount,a.maxVertexCount=this._maxVertexCount,a.maxIndexCount=this._maxIndexCount,a.geometryInitialized=this._geometryInitialized,a.matricesTexture=this._matricesTexture.toJSON(t),a.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(a.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(a.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(a.boundingBox=this.boundingBox.toJSON()));function n(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?a.background=this.background.toJSON():this.background.isTexture&&(a.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(a.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){a.geometry=n(t.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let l=o.shapes;if(Array.isArray(l))for(let h=0,c=l.length;h<c;h++){let d=l[h];n(t.shapes,d)}else n(t.shapes,l)}}if(this.isSkinnedMesh&&(a.bindMode=this.bindMode,a.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(n(t.skeletons,this.skeleton),a.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let l=0,h=this.material.length;l<h;l++)o.push(n(t.materials,this.material[l]));a.material=o}else a.material=n(t.materials,this.material);if(this.children.length>0){a.children=[];for(let o=0;o<this.children.length;o++)a.children.push(this.children[o].toJSON(t).object)}if(this.animations.length>0){a.animations=[];for(let o=0;o<this.animations.length;o++){let l=this.animations[o];a.animations.push(n(t.animations,l))}}if(i){let o=s(t.geometries),l=s(t.materials),h=s(t.textures),c=s(t.images),d=s(t.shapes),u=s(t.skeletons),f=s(t.animations),_=s(t.nodes);o.length>0&&(r.geometries=o),l.length>0&&(r.materials=l),h.length>0&&(r.textures=h),c.length>0&&(r.images=c),d.length>0&&(r.shapes=d),u.length>0&&(r.skeletons=u),f.length>0&&(r.animations=f),_.length>0&&(r.nodes=_)}return r.object=a,r;function s(o){let l=[];for(let h in o){let c=o[h];delete c.metadata,l.push(c)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,i=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),i===!0)for(let r=0;r<t.children.length;r++){let a=t.children[r];this.add(a.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};cr.DEFAULT_UP=new X(0,1,0);cr.DEFAULT_MATRIX_AUTO_UPDATE=!0;cr.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ti=class extends cr{constructor(){super(),this.isGroup=!0,this.type="Group"}},_v={type:"move"},Ch=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ti,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ti,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ti,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let r=null,a=null,n=null,s=this._targetRay,o=this._grip,l=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(l&&e.hand){n=!0;for(let _ of e.hand.values()){let x=t.getJointPose(_,i),p=this._getHandJoint(l,_);x!==null&&(p.matrix.fromArray(x.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=x.radius),p.visible=x!==null}let h=l.joints["index-finger-tip"],c=l.joints["thumb-tip"],d=h.position.distanceTo(c.position),u=.02,f=.005;l.inputState.pinching&&d>u+f?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!l.inputState.pinching&&d<=u-f&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else o!==null&&e.gripSpace&&(a=t.getPose(e.gripSpace,i),a!==null&&(o.matrix.fromArray(a.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,a.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(a.linearVelocity)):o.hasLinearVelocity=!1,a.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(a.angularVelocity)):o.hasAngularVelocity=!1,o.eventsEnabled&&o.dispatchEvent({type:"gripUpdated",data:e,target:this})));s!==null&&(r=t.getPose(e.targetRaySpace,i),r===null&&a!==null&&(r=a),r!==null&&(s.matrix.fromArray(r.transform.matrix),s.matrix.decompose(s.position,s.quaternion,s.scale),s.matrixWorldNeedsUpdate=!0,r.linearVelocity?(s.hasLinearVelocity=!0,s.linearVelocity.copy(r.linearVelocity)):s.hasLinearVelocity=!1,r.angularVelocity?(s.hasAngularVelocity=!0,s.angularVelocity.copy(r.angularVelocity)):s.hasAngularVelocity=!1,this.dispatchEvent(_v)))}return s!==null&&(s.visible=r!==null),o!==null&&(o.visible=a!==null),l!==null&&(l.visible=n!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Ti;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Kp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ma={h:0,s:0,l:0},xo={h:0,s:0,l:0};function Ph(e,t,i){return i<0&&(i+=1),i>1&&(i-=1),i<1/6?e+(t-e)*6*i:i<1/2?t:i<2/3?e+(t-e)*6*(2/3-i):e}var lt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=or){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,ft.colorSpaceToWorking(this,t),this}setRGB(e,t,i,r=ft.workingColorSpace){return this.r=e,this.g=t,this.b=i,ft.colorSpaceToWorking(this,r),this}setHSL(e,t,i,r=ft.workingColorSpace){if(e=Vc(e,1),t=st(t,0,1),i=st(i,0,1),t===0)this.r=this.g=this.b=i;else{let a=i<=.5?i*(1+t):i+t-i*t,n=2*i-a;this.r=Ph(n,a,e+1/3),this.g=Ph(n,a,e),this.b=Ph(n,a,e-1/3)}return ft.colorSpaceToWorking(this,r),this}setStyle(e,t=or){function i(a){a!==void 0&&parseFloat(a)<1&&Ye("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let a,n=r[1],s=r[2];switch(n){case"rgb":case"rgba":if(a=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(s))return i(a[4]),this.setRGB(Math.min(255,parseInt(a[1],10))/255,Math.min(255,parseInt(a[2],10))/255,Math.min(255,parseInt(a[3],10))/255,t);if(a=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(s))return i(a[4]),this.setRGB(Math.min(100,parseFloat(a[1]))/100,Math.min(100,parseFloat(a[2]))/100,Math.min(100,parseFloat(a[3]))/100,t);break;case"hsl":case"hsla":if(a=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(s))return i(a[4]),this.setHSL(parseFloat(a[1])/360,parseFloat(a[2])/100,parseFloat(a[3])/100,t);break;default:Ye("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let a=r[1],n=a.length;if(n===3)return this.setRGB(parseInt(a.charAt(0),16)/15,parseInt(a.charAt(1),16)/15,parseInt(a.charAt(2),16)/15,t);if(n===6)return this.setHex(parseInt(a,16),t);Ye("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=or){let i=Kp[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ye("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=sa(e.r),this.g=sa(e.g),this.b=sa(e.b),this}copyLinearToSRGB(e){return this.r=Vn(e.r),this.g=Vn(e.g),this.b=Vn(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=or){return ft.workingToColorSpace(Li.copy(this),e),Math.round(st(Li.r*255,0,255))*65536+Math.round(st(Li.g*255,0,255))*256+Math.round(st(Li.b*255,0,255))}getHexString(e=or){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=ft.workingColorSpace){ft.workingToColorSpace(Li.copy(this),t);let i=Li.r,r=Li.g,a=Li.b,n=Math.max(i,r,a),s=Math.min(i,r,a),o,l,h=(s+n)/2;if(s===n)o=0,l=0;else{let c=n-s;switch(l=h<=.5?c/(n+s):c/(2-n-s),n){case i:o=(r-a)/c+(r<a?6:0);break;case r:o=(a-i)/c+2;break;case a:o=(i-r)/c+4;break}o/=6}return e.h=o,e.s=l,e.l=h,e}getRGB(e,t=ft.workingColorSpace){return ft.workingToColorSpace(Li.copy(this),t),e.r=Li.r,e.g=Li.g,e.b=Li.b,e}getStyle(e=or){ft.workingToColorSpace(Li.copy(this),e);let t=Li.r,i=Li.g,r=Li.b;return e!==or?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(r*255)})`}offsetHSL(e,t,i){return this.getHSL(Ma),this.setHSL(Ma.h+e,Ma.s+t,Ma.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Ma),e.getHSL(xo);let i=Ps(Ma.h,xo.h,t),r=Ps(Ma.s,xo.s,t),a=Ps(Ma.l,xo.l,t);return this.setHSL(i,r,a),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,r=this.b,a=e.elements;return this.r=a[0]*t+a[3]*i+a[6]*r,this.g=a[1]*t+a[4]*i+a[7]*r,this.b=a[2]*t+a[5]*i+a[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Li=new lt;lt.NAMES=Kp;var Jp=class extends cr{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Us,this.environmentIntensity=1,this.environmentRotation=new Us,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Mr=new X,Zr=new X,Lh=new X,Qr=new X,Rn=new X,Cn=new X,Nf=new X,Dh=new X,Nh=new X,Ih=new X,Uh=new Ft,Oh=new Ft,Fh=new Ft,Ms=class kn{constructor(t=new X,i=new X,r=new X){this.a=t,this.b=i,this.c=r}static getNormal(t,i,r,a){a.subVectors(r,i),Mr.subVectors(t,i),a.cross(Mr);let n=a.lengthSq();return n>0?a.multiplyScalar(1/Math.sqrt(n)):a.set(0,0,0)}static getBarycoord(t,i,r,a,n){Mr.subVectors(a,i),Zr.subVectors(r,i),Lh.subVectors(t,i);let s=Mr.dot(Mr),o=Mr.dot(Zr),l=Mr.dot(Lh),h=Zr.dot(Zr),c=Zr.dot(Lh),d=s*h-o*o;if(d===0)return n.set(0,0,0),null;let u=1/d,f=(h*l-o*c)*u,_=(s*c-o*l)*u;return n.set(1-f-_,_,f)}static containsPoint(t,i,r,a){return this.getBarycoord(t,i,r,a,Qr)===null?!1:Qr.x>=0&&Qr.y>=0&&Qr.x+Qr.y<=1}static getInterpolation(t,i,r,a,n,s,o,l){return this.getBarycoord(t,i,r,a,Qr)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(n,Qr.x),l.addScaledVector(s,Qr.y),l.addScaledVector(o,Qr.z),l)}static getInterpolatedAttribute(t,i,r,a,n,s){return Uh.setScalar(0),Oh.setScalar(0),Fh.setScalar(0),Uh.fromBufferAttribute(t,i),Oh.fromBufferAttribute(t,r),Fh.fromBufferAttribute(t,a),s.setScalar(0),s.addScaledVector(Uh,n.x),s.addScaledVector(Oh,n.y),s.addScaledVector(Fh,n.z),s}static isFrontFacing(t,i,r,a){return Mr.subVectors(r,i),Zr.subVectors(t,i),Mr.cross(Zr).dot(a)<0}set(t,i,r){return this.a.copy(t),this.b.copy(i),this.c.copy(r),this}setFromPointsAndIndices(t,i,r,a){return this.a.copy(t[i]),this.b.copy(t[r]),this.c.copy(t[a]),this}setFromAttributeAndIndices(t,i,r,a){return this.a.fromBufferAttribute(t,i),this.b.fromBufferAttribute(t,r),this.c.fromBufferAttribute(t,a),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Mr.subVectors(this.c,this.b),Zr.subVectors(this.a,this.b),Mr.cross(Zr).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return kn.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,i){return kn.getBarycoord(t,this.a,this.b,this.c,i)}getInterpolation(t,i,r,a,n){return kn.getInterpolation(t,this.a,this.b,this.c,i,r,a,n)}containsPoint(t){return kn.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return kn.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,i){let r=this.a,a=this.b,n=this.c,s,o;Rn.subVectors(a,r),Cn.subVectors(n,r),Dh.subVectors(t,r);let l=Rn.dot(Dh),h=Cn.dot(Dh);if(l<=0&&h<=0)return i.copy(r);Nh.subVectors(t,a);let c=Rn.dot(Nh),d=Cn.dot(Nh);if(c>=0&&d<=c)return i.copy(a);let u=l*d-c*h;if(u<=0&&l>=0&&c<=0&&l-c>0)return s=l/(l-c),i.copy(r).addScaledVector(Rn,s);Ih.subVectors(t,n);let f=Rn.dot(Ih),_=Cn.dot(Ih);if(_>=0&&f<=_)return i.copy(n);let x=f*h-l*_;if(x<=0&&h>=0&&_<=0)return o=h/(h-_),i.copy(r).addScaledVector(Cn,o);let p=c*_-f*d;if(p<=0&&d-c>=0&&f-_>=0)return Nf.subVectors(n,a),o=(d-c)/(d-c+(f-_)),i.copy(a).addScaledVector(Nf,o);let m=1/(p+x+u);return s=x*m,o=u*m,i.copy(r).addScaledVector(Rn,s).addScaledVector(Cn,o)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Ca=class{constructor(e=new X(1/0,1/0,1/0),t=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Sr.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Sr.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Sr.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let a=i.getAttribute("position");if(t===!0&&a!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let n=0,s=a.count;n<s;n++)e.isMesh===!0?e.getVertexPosition(n,Sr):Sr.fromBufferAttribute(a,n),Sr.applyMatrix4(e.matrixWorld),this.expandByPoint(Sr);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Mo.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Mo.copy(i.boundingBox)),Mo.applyMatrix4(e.matrixWorld),this.union(Mo)}let r=e.children;for(let a=0,n=r.length;a<n;a++)this.expandByObject(r[a],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Sr),Sr.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ss),So.subVectors(this.max,Ss),Pn.subVectors(e.a,Ss),Ln.subVectors(e.b,Ss),Dn.subVectors(e.c,Ss),Sa.subVectors(Ln,Pn),ya.subVectors(Dn,Ln),Xa.subVectors(Pn,Dn);let t=[0,-Sa.z,Sa.y,0,-ya.z,ya.y,0,-Xa.z,Xa.y,Sa.z,0,-Sa.x,ya.z,0,-ya.x,Xa.z,0,-Xa.x,-Sa.y,Sa.x,0,-ya.y,ya.x,0,-Xa.y,Xa.x,0];return!kh(t,Pn,Ln,Dn,So)||(t=[1,0,0,0,1,0,0,0,1],!kh(t,Pn,Ln,Dn,So))?!1:(yo.crossVectors(Sa,ya),t=[yo.x,yo.y,yo.z],kh(t,Pn,Ln,Dn,So))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Sr).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Sr).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ea[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ea[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ea[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ea[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ea[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ea[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ea[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ea[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ea),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ea=[new X,new X,new X,new X,new X,new X,new X,new X],Sr=new X,Mo=new Ca,Pn=new X,Ln=new X,Dn=new X,Sa=new X,ya=new X,Xa=new X,Ss=new X,So=new X,yo=new X,Ya=new X;function kh(e,t,i,r,a){for(let n=0,s=e.length-3;n<=s;n+=3){Ya.fromArray(e,n);let o=a.x*Math.abs(Ya.x)+a.y*Math.abs(Ya.y)+a.z*Math.abs(Ya.z),l=t.dot(Ya),h=i.dot(Ya),c=r.dot(Ya);if(Math.max(-Math.max(l,h,c),Math.min(l,h,c))>o)return!1}return!0}var si=new X,Eo=new rt,vv=0,ii=class extends Ra{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:vv++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=F_,this.updateRanges=[],this.gpuType=Br,this.version=0,this._normalizationScale=e!==void 0?Wc(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let r=0,a=this.itemSize;r<a;r++)this.array[e+r]=t.array[i+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Eo.fromBufferAttribute(this,t),Eo.applyMatrix3(e),this.setXY(t,Eo.x,Eo.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)si.fromBufferAttribute(this,t),si.applyMatrix3(e),this.setXYZ(t,si.x,si.y,si.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)si.fromBufferAttribute(this,t),si.applyMatrix4(e),this.setXYZ(t,si.x,si.y,si.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)si.fromBufferAttribute(this,t),si.applyNormalMatrix(e),this.setXYZ(t,si.x,si.y,si.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)si.fromBufferAttribute(this,t),si.transformDirection(e),this.setXYZ(t,si.x,si.y,si.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this}setXYZW(e,t,i,r,a){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),a=this._normalize(a)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this.array[e+3]=a,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Wp(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):jp(e,this.array)}},Zp=class extends ii{constructor(e,t,i){super(new Uint16Array(e),t,i)}},Qp=class extends ii{constructor(e,t,i){super(new Uint32Array(e),t,i)}},Ai=class extends ii{constructor(e,t,i){super(new Float32Array(e),t,i)}},xv=new Ca,ys=new X,Bh=new X,Os=class{constructor(e=new X,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):xv.setFromPoints(e).getCenter(i);let r=0;for(let a=0,n=e.length;a<n;a++)r=Math.max(r,i.distanceToSquared(e[a]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ys.subVectors(e,this.center);let t=ys.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),r=(i-this.radius)*.5;this.center.addScaledVector(ys,r/i),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Bh.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ys.copy(e.center).add(Bh)),this.expandByPoint(ys.copy(e.center).sub(Bh))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Mv=0,sr=new ti,zh=new cr,Nn=new X,er=new Ca,Es=new Ca,Si=new X,pi=class em extends Ra{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Mv++}),this.uuid=$n(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(k_(t)?Qp:Zp)(t,1):this.index=t,this}setIndirect(t,i=0){return this.indirect=t,this.indirectOffset=i,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,i){return this.attributes[t]=i,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,i,r=0){this.groups.push({start:t,count:i,materialIndex:r})}clearGroups(){this.groups=[]}setDrawRange(t,i){this.drawRange.start=t,this.drawRange.count=i}applyMatrix4(t){let i=this.attributes.position;i!==void 0&&(i.applyMatrix4(t),i.needsUpdate=!0);let r=this.attributes.normal;if(r!==void 0){let n=new et().getNormalMatrix(t);r.applyNormalMatrix(n),r.needsUpdate=!0}let a=this.attributes.tangent;return a!==void 0&&(a.transformDirection(t),a.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return sr.makeRotationFromQuaternion(t),this.applyMatrix4(sr),this}rotateX(t){return sr.makeRotationX(t),this.applyMatrix4(sr),this}rotateY(t){return sr.makeRotationY(t),this.applyMatrix4(sr),this}rotateZ(t){return sr.makeRotationZ(t),this.applyMatrix4(sr),this}translate(t,i,r){return sr.makeTranslation(t,i,r),this.applyMatrix4(sr),this}scale(t,i,r){return sr.makeScale(t,i,r),this.applyMatrix4(sr),this}lookAt(t){return zh.lookAt(t),zh.updateMatrix(),this.applyMatrix4(zh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Nn).negate(),this.translate(Nn.x,Nn.y,Nn.z),this}setFromPoints(t){let i=this.getAttribute("position");if(i===void 0){let r=[];for(let a=0,n=t.length;a<n;a++){let s=t[a];r.push(s.x,s.y,s.z||0)}this.setAttribute("position",new Ai(r,3))}else{let r=Math.min(t.length,i.count);for(let a=0;a<r;a++){let n=t[a];i.setXYZ(a,n.x,n.y,n.z||0)}t.length>i.count&&Ye("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),i.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ca);let t=this.attributes.position,i=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ze("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),i)for(let r=0,a=i.length;r<a;r++){let n=i[r];er.setFromBufferAttribute(n),this.morphTargetsRelative?(Si.addVectors(this.boundingBox.min,er.min),this.boundingBox.expandByPoint(Si),Si.addVectors(this.boundingBox.max,er.max),this.boundingBox.expandByPoint(Si)):(this.boundingBox.expandByPoint(er.min),this.boundingBox.expandByPoint(er.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ze('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Os);let t=this.attributes.position,i=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ze("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(t){let r=this.boundingSphere.center;if(er.setFromBufferAttribute(t),i)for(let n=0,s=i.length;n<s;n++){let o=i[n];Es.setFromBufferAttribute(o),this.morphTargetsRelative?(Si.addVectors(er.min,Es.min),er.expandByPoint(Si),Si.addVectors(er.max,Es.max),er.expandByPoint(Si)):(er.expandByPoint(Es.min),er.expandByPoint(Es.max))}er.getCenter(r);let a=0;for(let n=0,s=t.count;n<s;n++)Si.fromBufferAttribute(t,n),a=Math.max(a,r.distanceToSquared(Si));if(i)for(let n=0,s=i.length;n<s;n++){let o=i[n],l=this.morphTargetsRelative;for(let h=0,c=o.count;h<c;h++)Si.fromBufferAttribute(o,h),l&&(Nn.fromBufferAttribute(t,h),Si.add(Nn)),a=Math.max(a,r.distanceToSquared(Si))}this.boundingSphere.radius=Math.sqrt(a),isNaN(this.boundingSphere.radius)&&Ze('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,i=this.attributes;if(t===null||i.position===void 0||i.normal===void 0||i.uv===void 0){Ze("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let r=i.position,a=i.normal,n=i.uv,s=this.getAttribute("tangent");(s===void 0||s.count!==r.count)&&(s=new ii(new Float32Array(4*r.count),4),this.setAttribute("tangent",s));let o=[],l=[],h=new Uint8Array(r.count);for(let U=0;U<r.count;U++)o[U]=new X,l[U]=new X;let c=new X,d=new X,u=new X,f=new rt,_=new rt,x=new rt,p=new X,m=new X;function w(U,W,N){h[U]=h[W]=h[N]=1,c.fromBufferAttribute(r,U),d.fromBufferAttribute(r,W),u.fromBufferAttribute(r,N),f.fromBufferAttribute(n,U),_.fromBufferAttribute(n,W),x.fromBufferAttribute(n,N),d.sub(c),u.sub(c),_.sub(f),x.sub(f);let B=1/(_.x*x.y-x.x*_.y);isFinite(B)&&(p.copy(d).multiplyScalar(x.y).addScaledVector(u,-_.y).multiplyScalar(B),m.copy(u).multiplyScalar(_.x).addScaledVector(d,-x.x).multiplyScalar(B),o[U].add(p),o[W].add(p),o[N].add(p),l[U].add(m),l[W].add(m),l[N].add(m))}let R=this.groups;R.length===0&&(R=[{start:0,count:t.count}]);for(let U=0,W=R.length;U<W;++U){let N=R[U],B=N.start,I=N.count;for(let L=B,G=B+I;L<G;L+=3)w(t.getX(L+0),t.getX(L+1),t.getX(L+2))}let E=new X,T=new X,P=new X,v=new X;function b(U){P.fromBufferAttribute(a,U),v.copy(P);let W=o[U];E.copy(W),E.sub(P.multiplyScalar(P.dot(W))).normalize(),T.crossVectors(v,W);let N=T.dot(l[U])<0?-1:1;s.setXYZW(U,E.x,E.y,E.z,N)}for(let U=0,W=r.count;U<W;++U)h[U]&&b(U);this._transformed=!0}computeVertexNormals(){let t=this.index,i=this.getAttribute("position");if(i!==void 0){let r=this.getAttribute("normal");if(r===void 0||r.count!==i.count)r=new ii(new Float32Array(i.count*3),3),this.setAttribute("normal",r);else for(let u=0,f=r.count;u<f;u++)r.setXYZ(u,0,0,0);let a=new X,n=new X,s=new X,o=new X,l=new X,h=new X,c=new X,d=new X;if(t)for(let u=0,f=t.count;u<f;u+=3){let _=t.getX(u+0),x=t.getX(u+1),p=t.getX(u+2);a.fromBufferAttribute(i,_),n.fromBufferAttribute(i,x),s.fromBufferAttribute(i,p),c.subVectors(s,n),d.subVectors(a,n),c.cross(d),o.fromBufferAttribute(r,_),l.fromBufferAttribute(r,x),h.fromBufferAttribute(r,p),o.add(c),l.add(c),h.add(c),r.setXYZ(_,o.x,o.y,o.z),r.setXYZ(x,l.x,l.y,l.z),r.setXYZ(p,h.x,h.y,h.z)}else for(let u=0,f=i.count;u<f;u+=3)a.fromBufferAttribute(i,u+0),n.fromBufferAttribute(i,u+1),s.fromBufferAttribute(i,u+2),c.subVectors(s,n),d.subVectors(a,n),c.cross(d),r.setXYZ(u+0,c.x,c.y,c.z),r.setXYZ(u+1,c.x,c.y,c.z),r.setXYZ(u+2,c.x,c.y,c.z);this.normalizeNormals(),r.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let i=0,r=t.count;i<r;i++)Si.fromBufferAttribute(t,i),Si.normalize(),t.setXYZ(i,Si.x,Si.y,Si.z)}toNonIndexed(){function t(o,l){let h=o.array,c=o.itemSize,d=o.normalized,u=new h.constructor(l.length*c),f=0,_=0;for(let x=0,p=l.length;x<p;x++){o.isInterleavedBufferAttribute?f=l[x]*o.data.stride+o.offset:f=l[x]*c;for(let m=0;m<c;m++)u[_++]=h[f++]}return new ii(u,c,d)}if(this.index===null)return Ye("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let i=new em,r=this.index.array,a=this.attributes;for(let o in a){let l=a[o],h=t(l,r);i.setAttribute(o,h)}let n=this.morphAttributes;for(let o in n){let l=[],h=n[o];for(let c=0,d=h.length;c<d;c++){let u=h[c],f=t(u,r);l.push(f)}i.morphAttributes[o]=l}i.morphTargetsRelative=this.morphTargetsRelative;let s=this.groups;for(let o=0,l=s.length;o<l;o++){let h=s[o];i.addGroup(h.start,h.count,h.materialIndex)}return i}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let h in l)l[h]!==void 0&&(t[h]=l[h]);return t}t.data={attributes:{}};let i=this.index;i!==null&&(t.data.index={type:i.array.constructor.name,array:Array.prototype.slice.call(i.array)});let r=this.attributes;for(let l in r){let h=r[l];t.data.attributes[l]=h.toJSON(t.data)}let a={},n=!1;for(let l in this.morphAttributes){let h=this.morphAttributes[l],c=[];for(let d=0,u=h.length;d<u;d++){let f=h[d];c.push(f.toJSON(t.data))}c.length>0&&(a[l]=c,n=!0)}n&&(t.data.morphAttributes=a,t.data.morphTargetsRelative=this.morphTargetsRelative);let s=this.groups;s.length>0&&(t.data.groups=JSON.parse(JSON.stringify(s)));let o=this.boundingSphere;return o!==null&&(t.data.boundingSphere=o.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let i={};this.name=t.name;let r=t.index;r!==null&&this.setIndex(r.clone());let a=t.attributes;for(let h in a){let c=a[h];this.setAttribute(h,c.clone(i))}let n=t.morphAttributes;for(let h in n){let c=[],d=n[h];for(let u=0,f=d.length;u<f;u++)c.push(d[u].clone(i));this.morphAttributes[h]=c}this.morphTargetsRelative=t.morphTargetsRelative;let s=t.groups;for(let h=0,c=s.length;h<c;h++){let d=s[h];this.addGroup(d.start,d.count,d.materialIndex)}let o=t.boundingBox;o!==null&&(this.boundingBox=o.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Hh=new X,Sv=new X,yv=new et,ia=class{constructor(e=new X(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,r){return this.normal.set(e,t,i),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let r=Hh.subVectors(i,t).cross(Sv.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let r=e.delta(Hh),a=this.normal.dot(r);if(a===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let n=-(e.start.dot(this.normal)+this.constant)/a;return i===!0&&(n<0||n>1)?null:t.copy(e.start).addScaledVector(r,n)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||yv.getNormalMatrix(e),r=this.coplanarPoint(Hh).applyMatrix4(e),a=this.normal.applyMatrix3(i).normalize();return this.constant=-r.dot(a),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Ev=0,Kn=class extends Ra{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Ev++}),this.uuid=$n(),this.name="",this.type="Material",this.blending=Rs,this.side=Ka,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Sp,this.blendDst=yp,this.blendEquation=Fn,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new lt(0,0,0),this.blendAlpha=0,this.depthFunc=Ls,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=L_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Eh,this.stencilZFail=Eh,this.stencilZPass=Eh,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ye(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Ye(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(i):r&&r.isVector2&&i&&i.isVector2||r&&r.isEuler&&i&&i.isEuler||r&&r.isVector3&&i&&i.isVector3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(a=>a.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function r(a){let n=[];for(let s in a){let o=a[s];delete o.metadata,n.push(o)}return n}if(t){let a=r(e.textures),n=r(e.images);a.length>0&&(i.textures=a),n.length>0&&(i.images=n)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new lt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new ia().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new rt().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new rt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let r=t.length;i=new Array(r);for(let a=0;a!==r;++a)i[a]=t[a].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},ta=new X,Gh=new X,bo=new X,wo=new X,hl=class{constructor(e=new X,t=new X(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ta)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ta.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ta.copy(this.origin).addScaledVector(this.direction,t),ta.distanceToSquared(e))}distanceSqToSegment(e,t,i,r){Gh.copy(e).add(t).multiplyScalar(.5),bo.copy(t).sub(e).normalize(),wo.copy(this.origin).sub(Gh);let a=e.distanceTo(t)*.5,n=-this.direction.dot(bo),s=wo.dot(this.direction),o=-wo.dot(bo),l=wo.lengthSq(),h=Math.abs(1-n*n),c,d,u,f;if(h>0)if(c=n*o-s,d=n*s-o,f=a*h,c>=0)if(d>=-f)if(d<=f){let _=1/h;c*=_,d*=_,u=c*(c+n*d+2*s)+d*(n*c+d+2*o)+l}else d=a,c=Math.max(0,-(n*d+s)),u=-c*c+d*(d+2*o)+l;else d=-a,c=Math.max(0,-(n*d+s)),u=-c*c+d*(d+2*o)+l;else d<=-f?(c=Math.max(0,-(-n*a+s)),d=c>0?-a:Math.min(Math.max(-a,-o),a),u=-c*c+d*(d+2*o)+l):d<=f?(c=0,d=Math.min(Math.max(-a,-o),a),u=d*(d+2*o)+l):(c=Math.max(0,-(n*a+s)),d=c>0?a:Math.min(Math.max(-a,-o),a),u=-c*c+d*(d+2*o)+l);else d=n>0?-a:a,c=Math.max(0,-(n*d+s)),u=-c*c+d*(d+2*o)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,c),r&&r.copy(Gh).addScaledVector(bo,d),u}intersectSphere(e,t){if(e.radius<0)return null;ta.subVectors(e.center,this.origin);let i=ta.dot(this.direction),r=ta.dot(ta)-i*i,a=e.radius*e.radius;if(r>a)return null;let n=Math.sqrt(a-r),s=i-n,o=i+n;return o<0?null:s<0?this.at(o,t):this.at(s,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,r,a,n,s,o,l=1/this.direction.x,h=1/this.direction.y,c=1/this.direction.z,d=this.origin;return l>=0?(i=(e.min.x-d.x)*l,r=(e.max.x-d.x)*l):(i=(e.max.x-d.x)*l,r=(e.min.x-d.x)*l),h>=0?(a=(e.min.y-d.y)*h,n=(e.max.y-d.y)*h):(a=(e.max.y-d.y)*h,n=(e.min.y-d.y)*h),i>n||a>r||((a>i||isNaN(i))&&(i=a),(n<r||isNaN(r))&&(r=n),c>=0?(s=(e.min.z-d.z)*c,o=(e.max.z-d.z)*c):(s=(e.max.z-d.z)*c,o=(e.min.z-d.z)*c),i>o||s>r)||((s>i||i!==i)&&(i=s),(o<r||r!==r)&&(r=o),r<0)?null:this.at(i>=0?i:r,t)}intersectsBox(e){return this.intersectBox(e,ta)!==null}intersectTriangle(e,t,i,r,a){let n=this.origin,s=this.direction,o=s.x,l=s.y,h=s.z,c=e.x-n.x,d=e.y-n.y,u=e.z-n.z,f=t.x-n.x,_=t.y-n.y,x=t.z-n.z,p=i.x-n.x,m=i.y-n.y,w=i.z-n.z,R=Math.abs(o),E=Math.abs(l),T=Math.abs(h),P,v,b,U,W,N,B,I,L,G,Z,O;if(R>=E&&R>=T?(b=o,N=c,L=f,O=p,o>=0?(P=l,v=h,U=d,W=u,B=_,I=x,G=m,Z=w):(P=h,v=l,U=u,W=d,B=x,I=_,G=w,Z=m)):E>=T?(b=l,N=d,L=_,O=m,l>=0?(P=h,v=o,U=u,W=c,B=x,I=f,G=w,Z=p):(P=o,v=h,U=c,W=u,B=f,I=x,G=p,Z=w)):(b=h,N=u,L=x,O=w,h>=0?(P=o,v=l,U=c,W=d,B=f,I=_,G=p,Z=m):(P=l,v=o,U=d,W=c,B=_,I=f,G=m,Z=p)),b===0)return null;let de=P/b,J=v/b,te=1/b,ne=U-de*N,Le=W-J*N,K=B-de*L,re=I-J*L,se=G-de*O,Ce=Z-J*O,Re=se*re-Ce*K,le=ne*Ce-Le*se,Fe=K*Le-re*ne;if(r){if(Re<0||le<0||Fe<0)return null}else if((Re<0||le<0||Fe<0)&&(Re>0||le>0||Fe>0))return null;let We=Re+le+Fe;if(We===0)return null;let we=te*(Re*N+le*L+Fe*O);return(We>0?we<0:we>0)?null:this.at(we/We,a)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Xc=class extends Kn{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new lt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Us,this.combine=Ep,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},If=new ti,qa=new hl,To=new Os,Uf=new X,Ao=new X,Ro=new X,Co=new X,Vh=new X,Po=new X,Of=new X,Lo=new X,Di=class extends cr{constructor(e=new pi,t=new Xc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,t=Object.keys(e);if(t.length>0){let i=e[t[0]];if(i!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=i.length;r<a;r++){let n=i[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[n]=r}}}}getVertexPosition(e,t){let i=this.geometry,r=i.attributes.position,a=i.morphAttributes.position,n=i.morphTargetsRelative;t.fromBufferAttribute(r,e);let s=this.morphTargetInfluences;if(a&&s){Po.set(0,0,0);for(let o=0,l=a.length;o<l;o++){let h=s[o],c=a[o];h!==0&&(Vh.fromBufferAttribute(c,e),n?Po.addScaledVector(Vh,h):Po.addScaledVector(Vh.sub(t),h))}t.add(Po)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.material,a=this.matrixWorld;r!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),To.copy(i.boundingSphere),To.applyMatrix4(a),qa.copy(e.ray).recast(e.near),!(To.containsPoint(qa.origin)===!1&&(qa.intersectSphere(To,Uf)===null||qa.origin.distanceToSquared(Uf)>(e.far-e.near)**2))&&(If.copy(a).invert(),qa.copy(e.ray).applyMatrix4(If),!(i.boundingBox!==null&&qa.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,qa)))}_computeIntersections(e,t,i){let r,a=this.geometry,n=this.material,s=a.index,o=a.attributes.position,l=a.attributes.uv,h=a.attributes.uv1,c=a.attributes.normal,d=a.groups,u=a.drawRange;if(s!==null)if(Array.isArray(n))for(let f=0,_=d.length;f<_;f++){let x=d[f],p=n[x.materialIndex],m=Math.max(x.start,u.start),w=Math.min(s.count,Math.min(x.start+x.count,u.start+u.count));for(let R=m,E=w;R<E;R+=3){let T=s.getX(R),P=s.getX(R+1),v=s.getX(R+2);r=Do(this,p,e,i,l,h,c,T,P,v),r&&(r.faceIndex=Math.floor(R/3),r.face.materialIndex=x.materialIndex,t.push(r))}}else{let f=Math.max(0,u.start),_=Math.min(s.count,u.start+u.count);for(let x=f,p=_;x<p;x+=3){let m=s.getX(x),w=s.getX(x+1),R=s.getX(x+2);r=Do(this,n,e,i,l,h,c,m,w,R),r&&(r.faceIndex=Math.floor(x/3),t.push(r))}}else if(o!==void 0)if(Array.isArray(n))for(let f=0,_=d.length;f<_;f++){let x=d[f],p=n[x.materialIndex],m=Math.max(x.start,u.start),w=Math.min(o.count,Math.min(x.start+x.count,u.start+u.count));for(let R=m,E=w;R<E;R+=3){let T=R,P=R+1,v=R+2;r=Do(this,p,e,i,l,h,c,T,P,v),r&&(r.faceIndex=Math.floor(R/3),r.face.materialIndex=x.materialIndex,t.push(r))}}else{let f=Math.max(0,u.start),_=Math.min(o.count,u.start+u.count);for(let x=f,p=_;x<p;x+=3){let m=x,w=x+1,R=x+2;r=Do(this,n,e,i,l,h,c,m,w,R),r&&(r.faceIndex=Math.floor(x/3),t.push(r))}}}};function bv(e,t,i,r,a,n,s,o){let l;if(t.side===Vi?l=r.intersectTriangle(s,n,a,!0,o):l=r.intersectTriangle(a,n,s,t.side===Ka,o),l===null)return null;Lo.copy(o),Lo.applyMatrix4(e.matrixWorld);let h=i.ray.origin.distanceTo(Lo);return h<i.near||h>i.far?null:{distance:h,point:Lo.clone(),object:e}}function Do(e,t,i,r,a,n,s,o,l,h){e.getVertexPosition(o,Ao),e.getVertexPosition(l,Ro),e.getVertexPosition(h,Co);let c=bv(e,t,i,r,Ao,Ro,Co,Of);if(c){let d=new X;Ms.getBarycoord(Of,Ao,Ro,Co,d),a&&(c.uv=Ms.getInterpolatedAttribute(a,o,l,h,d,new rt)),n&&(c.uv1=Ms.getInterpolatedAttribute(n,o,l,h,d,new rt)),s&&(c.normal=Ms.getInterpolatedAttribute(s,o,l,h,d,new X),c.normal.dot(r.direction)>0&&c.normal.multiplyScalar(-1));let u={a:o,b:l,c:h,normal:new X,materialIndex:0};Ms.getNormal(Ao,Ro,Co,u.normal),c.face=u,c.barycoord=d}return c}var Yc=class extends br{constructor(e=null,t=1,i=1,r,a,n,s,o,l=wi,h=wi,c,d){super(null,n,s,o,l,h,r,a,c,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}},$a=new Os,wv=new rt(.5,.5),No=new X,sl=class{constructor(e=new ia,t=new ia,i=new ia,r=new ia,a=new ia,n=new ia){this.planes=[e,t,i,r,a,n]}set(e,t,i,r,a,n){let s=this.planes;return s[0].copy(e),s[1].copy(t),s[2].copy(i),s[3].copy(r),s[4].copy(a),s[5].copy(n),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=yr,i=!1){let r=this.planes,a=e.elements,n=a[0],s=a[1],o=a[2],l=a[3],h=a[4],c=a[5],d=a[6],u=a[7],f=a[8],_=a[9],x=a[10],p=a[11],m=a[12],w=a[13],R=a[14],E=a[15];if(r[0].setComponents(l-n,u-h,p-f,E-m).normalize(),r[1].setComponents(l+n,u+h,p+f,E+m).normalize(),r[2].setComponents(l+s,u+c,p+_,E+w).normalize(),r[3].setComponents(l-s,u-c,p-_,E-w).normalize(),i)r[4].setComponents(o,d,x,R).normalize(),r[5].setComponents(l-o,u-d,p-x,E-R).normalize();else if(r[4].setComponents(l-o,u-d,p-x,E-R).normalize(),t===yr)r[5].setComponents(l+o,u+d,p+x,E+R).normalize();else if(t===al)r[5].setComponents(o,d,x,R).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),$a.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),$a.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere($a)}intersectsSprite(e){$a.center.set(0,0,0);let t=wv.distanceTo(e.center);return $a.radius=.7071067811865476+t,$a.applyMatrix4(e.matrixWorld),this.intersectsSphere($a)}intersectsSphere(e){let t=this.planes,i=e.center,r=-e.radius;for(let a=0;a<6;a++)if(t[a].distanceToPoint(i)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let r=t[i];if(No.x=r.normal.x>0?e.max.x:e.min.x,No.y=r.normal.y>0?e.max.y:e.min.y,No.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(No)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Ff=new ti,Tv=class tm{constructor(){this.coordinateSystem=yr,this._frustums=[],this._count=0}setFromArrayCamera(t){let i=t.cameras,r=this._frustums;for(let a=0;a<i.length;a++){let n=i[a];Ff.multiplyMatrices(n.projectionMatrix,n.matrixWorldInverse),r[a]===void 0&&(r[a]=new sl),r[a].setFromProjectionMatrix(Ff,n.coordinateSystem,n.reversedDepth)}return this._count=i.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let i=this._frustums;for(let r=0;r<this._count;r++)if(i[r].intersectsObject(t))return!0;return!1}intersectsSprite(t){let i=this._frustums;for(let r=0;r<this._count;r++)if(i[r].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let i=this._frustums;for(let r=0;r<this._count;r++)if(i[r].intersectsSphere(t))return!0;return!1}intersectsBox(t){let i=this._frustums;for(let r=0;r<this._count;r++)if(i[r].intersectsBox(t))return!0;return!1}containsPoint(t){let i=this._frustums;for(let r=0;r<this._count;r++)if(i[r].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let i=this._frustums,r=t._frustums;for(let a=0;a<t._count;a++)i[a]===void 0&&(i[a]=new sl),i[a].copy(r[a]);return this._count=t._count,this}clone(){return new tm().copy(this)}},im=class extends Kn{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new lt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},ol=new X,ll=new X,kf=new ti,bs=new hl,Io=new Os,Wh=new X,Bf=new X,Av=class extends cr{constructor(e=new pi,t=new im){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let r=1,a=t.count;r<a;r++)ol.fromBufferAttribute(t,r-1),ll.fromBufferAttribute(t,r),i[r]=i[r-1],i[r]+=ol.distanceTo(ll);e.setAttribute("lineDistance",new Ai(i,1))}else Ye("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.matrixWorld,a=e.params.Line.threshold,n=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Io.copy(i.boundingSphere),Io.applyMatrix4(r),Io.radius+=a,e.ray.intersectsSphere(Io)===!1)return;kf.copy(r).invert(),bs.copy(e.ray).applyMatrix4(kf);let s=a/((this.scale.x+this.scale.y+this.scale.z)/3),o=s*s,l=this.isLineSegments?2:1,h=i.index,c=i.attributes.position;if(h!==null){let d=Math.max(0,n.start),u=Math.min(h.count,n.start+n.count);for(let f=d,_=u-1;f<_;f+=l){let x=h.getX(f),p=h.getX(f+1),m=Uo(this,e,bs,o,x,p,f);m&&t.push(m)}if(this.isLineLoop){let f=h.getX(u-1),_=h.getX(d),x=Uo(this,e,bs,o,f,_,u-1);x&&t.push(x)}}else{let d=Math.max(0,n.start),u=Math.min(c.count,n.start+n.count);for(let f=d,_=u-1;f<_;f+=l){let x=Uo(this,e,bs,o,f,f+1,f);x&&t.push(x)}if(this.isLineLoop){let f=Uo(this,e,bs,o,u-1,d,u-1);f&&t.push(f)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,t=Object.keys(e);if(t.length>0){let i=e[t[0]];if(i!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=i.length;r<a;r++){let n=i[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[n]=r}}}}};function Uo(e,t,i,r,a,n,s){let o=e.geometry.attributes.position;if(ol.fromBufferAttribute(o,a),ll.fromBufferAttribute(o,n),i.distanceSqToSegment(ol,ll,Wh,Bf)>r)return;Wh.applyMatrix4(e.matrixWorld);let l=t.ray.origin.distanceTo(Wh);if(!(l<t.near||l>t.far))return{distance:l,point:Bf.clone().applyMatrix4(e.matrixWorld),index:s,face:null,faceIndex:null,barycoord:null,object:e}}var zf=new X,Hf=new X,Rv=class extends Av{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let r=0,a=t.count;r<a;r+=2)zf.fromBufferAttribute(t,r),Hf.fromBufferAttribute(t,r+1),i[r]=r===0?0:i[r-1],i[r+1]=i[r]+zf.distanceTo(Hf);e.setAttribute("lineDistance",new Ai(i,1))}else Ye("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},Cv=class extends Kn{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new lt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},Gf=new ti,Ic=new hl,Oo=new Os,Fo=new X,rm=class extends cr{constructor(e=new pi,t=new Cv){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.matrixWorld,a=e.params.Points.threshold,n=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Oo.copy(i.boundingSphere),Oo.applyMatrix4(r),Oo.radius+=a,e.ray.intersectsSphere(Oo)===!1)return;Gf.copy(r).invert(),Ic.copy(e.ray).applyMatrix4(Gf);let s=a/((this.scale.x+this.scale.y+this.scale.z)/3),o=s*s,l=i.index,h=i.attributes.position;if(l!==null){let c=Math.max(0,n.start),d=Math.min(l.count,n.start+n.count);for(let u=c,f=d;u<f;u++){let _=l.getX(u);Fo.fromBufferAttribute(h,_),Vf(Fo,_,o,r,e,t,this)}}else{let c=Math.max(0,n.start),d=Math.min(h.count,n.start+n.count);for(let u=c,f=d;u<f;u++)Fo.fromBufferAttribute(h,u),Vf(Fo,u,o,r,e,t,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,t=Object.keys(e);if(t.length>0){let i=e[t[0]];if(i!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=i.length;r<a;r++){let n=i[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[n]=r}}}}};function Vf(e,t,i,r,a,n,s){let o=Ic.distanceSqToPoint(e);if(o<i){let l=new X;Ic.closestPointToPoint(e,l),l.applyMatrix4(r);let h=a.ray.origin.distanceTo(l);if(h<a.near||h>a.far)return;n.push({distance:h,distanceToRay:Math.sqrt(o),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:s})}}var am=class extends br{constructor(e=[],t=Wn,i,r,a,n,s,o,l,h){super(e,t,i,r,a,n,s,o,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},Yn=class extends br{constructor(e,t,i=Gr,r,a,n,s=wi,o=wi,l,h=Aa,c=1){if(h!==Aa&&h!==Ta)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:c};super(d,r,a,n,s,o,h,i,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new jc(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},nm=class extends Yn{constructor(e,t=Gr,i=Wn,r,a,n=wi,s=wi,o,l=Aa){let h={width:e,height:e,depth:1},c=[h,h,h,h,h,h];super(e,e,t,i,r,a,n,s,o,l),this.image=c,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},sm=class extends br{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},qc=class om extends pi{constructor(t=1,i=1,r=1,a=1,n=1,s=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:i,depth:r,widthSegments:a,heightSegments:n,depthSegments:s};let o=this;a=Math.floor(a),n=Math.floor(n),s=Math.floor(s);let l=[],h=[],c=[],d=[],u=0,f=0;_("z","y","x",-1,-1,r,i,t,s,n,0),_("z","y","x",1,-1,r,i,-t,s,n,1),_("x","z","y",1,1,t,r,i,a,s,2),_("x","z","y",1,-1,t,r,-i,a,s,3),_("x","y","z",1,-1,t,i,r,a,n,4),_("x","y","z",-1,-1,t,i,-r,a,n,5),this.setIndex(l),this.setAttribute("position",new Ai(h,3)),this.setAttribute("normal",new Ai(c,3)),this.setAttribute("uv",new Ai(d,2));function _(x,p,m,w,R,E,T,P,v,b,U){let W=E/v,N=T/b,B=E/2,I=T/2,L=P/2,G=v+1,Z=b+1,O=0,de=0,J=new X;for(let te=0;te<Z;te++){let ne=te*N-I;for(let Le=0;Le<G;Le++){let K=Le*W-B;J[x]=K*w,J[p]=ne*R,J[m]=L,h.push(J.x,J.y,J.z),J[x]=0,J[p]=0,J[m]=P>0?1:-1,c.push(J.x,J.y,J.z),d.push(Le/v),d.push(1-te/b),O+=1}}for(let te=0;te<b;te++)for(let ne=0;ne<v;ne++){let Le=u+ne+G*te,K=u+ne+G*(te+1),re=u+(ne+1)+G*(te+1),se=u+(ne+1)+G*te;l.push(Le,K,se),l.push(K,re,se),de+=6}o.addGroup(f,de,U),f+=de,u+=O}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new om(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var lm=class hm extends pi{constructor(t=1,i=1,r=1,a=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:i,widthSegments:r,heightSegments:a};let n=t/2,s=i/2,o=Math.floor(r),l=Math.floor(a),h=o+1,c=l+1,d=t/o,u=i/l,f=[],_=[],x=[],p=[];for(let m=0;m<c;m++){let w=m*u-s;for(let R=0;R<h;R++){let E=R*d-n;_.push(E,-w,0),x.push(0,0,1),p.push(R/o),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let w=0;w<o;w++){let R=w+h*m,E=w+h*(m+1),T=w+1+h*(m+1),P=w+1+h*m;f.push(R,E,P),f.push(E,T,P)}this.setIndex(f),this.setAttribute("position",new Ai(_,3)),this.setAttribute("normal",new Ai(x,3)),this.setAttribute("uv",new Ai(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new hm(t.width,t.height,t.widthSegments,t.heightSegments)}};function qn(e){let t={};for(let i in e){t[i]={};for(let r in e[i]){let a=e[i][r];if(Wf(a))a.isRenderTargetTexture?(Ye("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[i][r]=null):t[i][r]=a.clone();else if(Array.isArray(a))if(Wf(a[0])){let n=[];for(let s=0,o=a.length;s<o;s++)n[s]=a[s].clone();t[i][r]=n}else t[i][r]=a.slice();else t[i][r]=a}}return t}function ki(e){let t={};for(let i=0;i<e.length;i++){let r=qn(e[i]);for(let a in r)t[a]=r[a]}return t}function Wf(e){return e&&(e.isColor||e.isMatrix3||e.isMatrix4||e.isVector2||e.isVector3||e.isVector4||e.isTexture||e.isQuaternion)}function Pv(e){let t=[];for(let i=0;i<e.length;i++)t.push(e[i].clone());return t}function cm(e){let t=e.getRenderTarget();return t===null?e.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ft.workingColorSpace}var Lv={clone:qn,merge:ki},Dv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Nv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Bi=class extends Kn{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Dv,this.fragmentShader=Nv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=qn(e.uniforms),this.uniformsGroups=Pv(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let a=this.uniforms[r].value;a&&a.isTexture?t.uniforms[r]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[r]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[r]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[r]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[r]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[r]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[r]={type:"m4",value:a.toArray()}:t.uniforms[r]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let r in this.extensions)this.extensions[r]===!0&&(i[r]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let r=e.uniforms[i];switch(this.uniforms[i]={},r.type){case"t":this.uniforms[i].value=t[r.value]||null;break;case"c":this.uniforms[i].value=new lt().setHex(r.value);break;case"v2":this.uniforms[i].value=new rt().fromArray(r.value);break;case"v3":this.uniforms[i].value=new X().fromArray(r.value);break;case"v4":this.uniforms[i].value=new Ft().fromArray(r.value);break;case"m3":this.uniforms[i].value=new et().fromArray(r.value);break;case"m4":this.uniforms[i].value=new ti().fromArray(r.value);break;default:this.uniforms[i].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Iv=class extends Bi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Uv=class extends Kn{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=C_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Ov=class extends Kn{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function In(e,t){return!e||e.constructor===t?e:typeof t.BYTES_PER_ELEMENT=="number"?new t(e):Array.prototype.slice.call(e)}function ko(e){return e!==void 0&&e.inTangents!==void 0&&e.outTangents!==void 0}var Fs=class{constructor(e,t,i,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,r=t[i],a=t[i-1];i:{e:{let n;t:{r:if(!(e<r)){for(let s=i+2;;){if(r===void 0){if(e<a)break r;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===s)break;if(a=r,r=t[++i],e<r)break e}n=t.length;break t}if(!(e>=a)){let s=t[1];e<s&&(i=2,a=s);for(let o=i-2;;){if(a===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===o)break;if(r=a,a=t[--i-1],e>=a)break e}n=i,i=0;break t}break i}for(;i<n;){let s=i+n>>>1;e<t[s]?n=s:i=s+1}if(r=t[i],a=t[i-1],a===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,a,r)}return this.interpolate_(i,a,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,r=this.valueSize,a=e*r;for(let n=0;n!==r;++n)t[n]=i[a+n];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Fv=class extends Fs{constructor(e,t,i,r){super(e,t,i,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:mf,endingEnd:mf}}intervalChanged_(e,t,i){let r=this.parameterPositions,a=e-2,n=e+1,s=r[a],o=r[n];if(s===void 0)switch(this.getSettings_().endingStart){case gf:a=e,s=2*t-i;break;case _f:a=r.length-2,s=t+r[a]-r[a+1];break;default:a=e,s=i}if(o===void 0)switch(this.getSettings_().endingEnd){case gf:n=e,o=2*i-t;break;case _f:n=1,o=i+r[1]-r[0];break;default:n=e-1,o=t}let l=(i-t)*.5,h=this.valueSize;this._weightPrev=l/(t-s),this._weightNext=l/(o-i),this._offsetPrev=a*h,this._offsetNext=n*h}interpolate_(e,t,i,r){let a=this.resultBuffer,n=this.sampleValues,s=this.valueSize,o=e*s,l=o-s,h=this._offsetPrev,c=this._offsetNext,d=this._weightPrev,u=this._weightNext,f=(i-t)/(r-t),_=f*f,x=_*f,p=-d*x+2*d*_-d*f,m=(1+d)*x+(-1.5-2*d)*_+(-.5+d)*f+1,w=(-1-u)*x+(1.5+u)*_+.5*f,R=u*x-u*_;for(let E=0;E!==s;++E)a[E]=p*n[h+E]+m*n[l+E]+w*n[o+E]+R*n[c+E];return a}},kv=class extends Fs{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e,t,i,r){let a=this.resultBuffer,n=this.sampleValues,s=this.valueSize,o=e*s,l=o-s,h=(i-t)/(r-t),c=1-h;for(let d=0;d!==s;++d)a[d]=n[l+d]*c+n[o+d]*h;return a}},Bv=class extends Fs{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e){return this.copySampleValue_(e-1)}},zv=class extends Fs{interpolate_(e,t,i,r){let a=this.resultBuffer,n=this.sampleValues,s=this.valueSize,o=e*s,l=o-s,h=this.inTangents,c=this.outTangents;if(!h||!c){let f=(i-t)/(r-t),_=1-f;for(let x=0;x!==s;++x)a[x]=n[l+x]*_+n[o+x]*f;return a}let d=s*2,u=e-1;for(let f=0;f!==s;++f){let _=n[l+f],x=n[o+f],p=u*d+f*2,m=c[p],w=c[p+1],R=e*d+f*2,E=h[R],T=h[R+1],P=Gv(i,t,m,E,r);a[f]=um(P,_,w,T,x)}return a}};function um(e,t,i,r,a){let n=1-e;return n*n*n*t+3*n*n*e*i+3*n*e*e*r+e*e*e*a}function Hv(e,t,i,r,a){let n=1-e;return 3*n*n*(i-t)+6*n*e*(r-i)+3*e*e*(a-r)}function Gv(e,t,i,r,a){let n=(e-t)/(a-t);for(let s=0;s<8;s++){let o=um(n,t,i,r,a)-e;if(Math.abs(o)<1e-10)break;let l=Hv(n,t,i,r,a);if(Math.abs(l)<1e-10)break;n=Math.max(0,Math.min(1,n-o/l))}return n}var Wr=class{constructor(e,t,i,r){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=In(t,this.TimeBufferType),this.values=In(i,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:In(e.times,Array),values:In(e.values,Array)};let r=e.getInterpolation();r!==e.DefaultInterpolation&&(i.interpolation=r),ko(e.settings)&&(i.settings={inTangents:In(e.settings.inTangents,Array),outTangents:In(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Bv(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new kv(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Fv(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new zv(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case tl:t=this.InterpolantFactoryMethodDiscrete;break;case Nc:t=this.InterpolantFactoryMethodLinear;break;case yh:t=this.InterpolantFactoryMethodSmooth;break;case pf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ye("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return tl;case this.InterpolantFactoryMethodLinear:return Nc;case this.InterpolantFactoryMethodSmooth:return yh;case this.InterpolantFactoryMethodBezier:return pf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,r=t.length;i!==r;++i)t[i]+=e;ko(this.settings)&&(jf(this.settings.inTangents,e),jf(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,r=t.length;i!==r;++i)t[i]*=e;ko(this.settings)&&(Xf(this.settings.inTangents,e),Xf(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,r=i.length,a=0,n=r-1;for(;a!==r&&i[a]<e;)++a;for(;n!==-1&&i[n]>t;)--n;if(++n,a!==0||n!==r){a>=n&&(n=Math.max(n,1),a=n-1);let s=this.getValueSize();this.times=i.slice(a,n),this.values=this.values.slice(a*s,n*s)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Ze("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,r=this.values,a=i.length;a===0&&(Ze("KeyframeTrack: Track is empty.",this),e=!1);let n=null;for(let s=0;s!==a;s++){let o=i[s];if(typeof o=="number"&&isNaN(o)){Ze("KeyframeTrack: Time is not a valid number.",this,s,o),e=!1;break}if(n!==null&&n>o){Ze("KeyframeTrack: Out of order keys.",this,s,o,n),e=!1;break}n=o}if(r!==void 0&&B_(r))for(let s=0,o=r.length;s!==o;++s){let l=r[s];if(isNaN(l)){Ze("KeyframeTrack: Value is not a valid number.",this,s,l),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),r=this.getInterpolation()===yh,a=e.length-1,n=1;for(let s=1;s<a;++s){let o=!1,l=e[s],h=e[s+1];if(l!==h&&(s!==1||l!==e[0]))if(r)o=!0;else{let c=s*i,d=c-i,u=c+i;for(let f=0;f!==i;++f){let _=t[c+f];if(_!==t[d+f]||_!==t[u+f]){o=!0;break}}}if(o){if(s!==n){e[n]=e[s];let c=s*i,d=n*i;for(let u=0;u!==i;++u)t[d+u]=t[c+u]}++n}}if(a>0){e[n]=e[a];for(let s=a*i,o=n*i,l=0;l!==i;++l)t[o+l]=t[s+l];++n}return n!==e.length?(this.times=e.slice(0,n),this.values=t.slice(0,n*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,r=new i(this.name,e,t);return r.createInterpolant=this.createInterpolant,ko(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function jf(e,t){for(let i=0,r=e.length;i!==r;i+=2)e[i]+=t}function Xf(e,t){for(let i=0,r=e.length;i!==r;i+=2)e[i]*=t}Wr.prototype.ValueTypeName="";Wr.prototype.TimeBufferType=Float32Array;Wr.prototype.ValueBufferType=Float32Array;Wr.prototype.DefaultInterpolation=Nc;var ks=class extends Wr{constructor(e,t,i){super(e,t,i)}};ks.prototype.ValueTypeName="bool";ks.prototype.ValueBufferType=Array;ks.prototype.DefaultInterpolation=tl;ks.prototype.InterpolantFactoryMethodLinear=void 0;ks.prototype.InterpolantFactoryMethodSmooth=void 0;var Vv=class extends Wr{constructor(e,t,i,r){super(e,t,i,r)}};Vv.prototype.ValueTypeName="color";var Wv=class extends Wr{constructor(e,t,i,r){super(e,t,i,r)}};Wv.prototype.ValueTypeName="number";var jv=class extends Fs{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e,t,i,r){let a=this.resultBuffer,n=this.sampleValues,s=this.valueSize,o=(i-t)/(r-t),l=e*s;for(let h=l+s;l!==h;l+=4)Er.slerpFlat(a,0,n,l-s,n,l,o);return a}},dm=class extends Wr{constructor(e,t,i,r){super(e,t,i,r)}InterpolantFactoryMethodLinear(e){return new jv(this.times,this.values,this.getValueSize(),e)}};dm.prototype.ValueTypeName="quaternion";dm.prototype.InterpolantFactoryMethodSmooth=void 0;var Bs=class extends Wr{constructor(e,t,i){super(e,t,i)}};Bs.prototype.ValueTypeName="string";Bs.prototype.ValueBufferType=Array;Bs.prototype.DefaultInterpolation=tl;Bs.prototype.InterpolantFactoryMethodLinear=void 0;Bs.prototype.InterpolantFactoryMethodSmooth=void 0;var Xv=class extends Wr{constructor(e,t,i,r){super(e,t,i,r)}};Xv.prototype.ValueTypeName="vector";var Yv=class{constructor(e,t,i){let r=this,a=!1,n=0,s=0,o,l=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(h){s++,a===!1&&r.onStart!==void 0&&r.onStart(h,n,s),a=!0},this.itemEnd=function(h){n++,r.onProgress!==void 0&&r.onProgress(h,n,s),n===s&&(a=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(h){r.onError!==void 0&&r.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),o?o(h):h},this.setURLModifier=function(h){return o=h,this},this.addHandler=function(h,c){return l.push(h,c),this},this.removeHandler=function(h){let c=l.indexOf(h);return c!==-1&&l.splice(c,2),this},this.getHandler=function(h){for(let c=0,d=l.length;c<d;c+=2){let u=l[c],f=l[c+1];if(u.global&&(u.lastIndex=0),u.test(h))return f}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},qv=new Yv,$v=class{constructor(e){this.manager=e!==void 0?e:qv,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(r,a){i.load(e,r,t,a)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};$v.DEFAULT_MATERIAL_NAME="__DEFAULT";var Kv=class extends cr{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new lt(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Bo=new X,zo=new Er,Or=new X,fm=class extends cr{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ti,this.projectionMatrix=new ti,this.projectionMatrixInverse=new ti,this.coordinateSystem=yr,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Bo,zo,Or),Or.x===1&&Or.y===1&&Or.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Bo,zo,Or.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Bo,zo,Or),Or.x===1&&Or.y===1&&Or.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Bo,zo,Or.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ea=new X,Yf=new rt,qf=new rt,lr=class extends fm{constructor(e=50,t=1,i=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Is*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Cs*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Is*2*Math.atan(Math.tan(Cs*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Ea.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ea.x,Ea.y).multiplyScalar(-e/Ea.z),Ea.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Ea.x,Ea.y).multiplyScalar(-e/Ea.z)}getViewSize(e,t){return this.getViewBounds(e,Yf,qf),t.subVectors(qf,Yf)}setViewOffset(e,t,i,r,a,n){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=a,this.view.height=n,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Cs*.5*this.fov)/this.zoom,i=2*t,r=this.aspect*i,a=-.5*r,n=this.view;if(this.view!==null&&this.view.enabled){let o=n.fullWidth,l=n.fullHeight;a+=n.offsetX*r/o,t-=n.offsetY*i/l,r*=n.width/o,i*=n.height/l}let s=this.filmOffset;s!==0&&(a+=e*s/this.getFilmWidth()),this.projectionMatrix.makePerspective(a,a+r,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},Jv=class extends fm{constructor(e=-1,t=1,i=1,r=-1,a=.1,n=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=r,this.near=a,this.far=n,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,r,a,n){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=a,this.view.height=n,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,r=(this.top+this.bottom)/2,a=i-e,n=i+e,s=r+t,o=r-t;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;a+=l*this.view.offsetX,n=a+l*this.view.width,s-=h*this.view.offsetY,o=s-h*this.view.height}this.projectionMatrix.makeOrthographic(a,n,s,o,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},pm=class extends Kv{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}},Un=-90,On=1,Uc=class extends cr{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new lr(Un,On,e,t);r.layers=this.layers,this.add(r);let a=new lr(Un,On,e,t);a.layers=this.layers,this.add(a);let n=new lr(Un,On,e,t);n.layers=this.layers,this.add(n);let s=new lr(Un,On,e,t);s.layers=this.layers,this.add(s);let o=new lr(Un,On,e,t);o.layers=this.layers,this.add(o);let l=new lr(Un,On,e,t);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,r,a,n,s,o]=t;for(let l of t)this.remove(l);if(e===yr)i.up.set(0,1,0),i.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),a.up.set(0,0,-1),a.lookAt(0,1,0),n.up.set(0,0,1),n.lookAt(0,-1,0),s.up.set(0,1,0),s.lookAt(0,0,1),o.up.set(0,1,0),o.lookAt(0,0,-1);else if(e===al)i.up.set(0,-1,0),i.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),a.up.set(0,0,1),a.lookAt(0,1,0),n.up.set(0,0,-1),n.lookAt(0,-1,0),s.up.set(0,-1,0),s.lookAt(0,0,1),o.up.set(0,-1,0),o.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let l of t)this.add(l),l.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[a,n,s,o,l,h]=this.children,c=e.getRenderTarget(),d=e.getActiveCubeFace(),u=e.getActiveMipmapLevel(),f=e.xr.enabled;e.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let x=!1;e.isWebGLRenderer===!0?x=e.state.buffers.depth.getReversed():x=e.reversedDepthBuffer,e.setRenderTarget(i,0,r),x&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,1,r),x&&e.autoClear===!1&&e.clearDepth(),e.render(t,n),e.setRenderTarget(i,2,r),x&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(i,3,r),x&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,4,r),x&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),i.texture.mipmapsAutoUpdate=_,e.setRenderTarget(i,5,r),x&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(c,d,u),e.xr.enabled=f,i.texture.needsPMREMUpdate=!0}},Zv=class extends lr{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}},$c="\\[\\]\\.:\\/",Qv=new RegExp("["+$c+"]","g"),Kc="[^"+$c+"]",ex="[^"+$c.replace("\\.","")+"]",tx=/((?:WC+[\/:])*)/.source.replace("WC",Kc),ix=/(WCOD+)?/.source.replace("WCOD",ex),rx=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Kc),ax=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Kc),nx=new RegExp("^"+tx+ix+rx+ax+"$"),sx=["material","materials","bones","map"],ox=class{constructor(e,t,i){let r=i||Jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,r=this._bindings[i];r!==void 0&&r.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let r=this._targetGroup.nCachedObjects_,a=i.length;r!==a;++r)i[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Jt=class Bn{constructor(t,i,r){this.path=i,this.parsedPath=r||Bn.parseTrackName(i),this.node=Bn.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,i,r){return t&&t.isAnimationObjectGroup?new Bn.Composite(t,i,r):new Bn(t,i,r)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Qv,"")}static parseTrackName(t){let i=nx.exec(t);if(i===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let r={nodeName:i[2],objectName:i[3],objectIndex:i[4],propertyName:i[5],propertyIndex:i[6]},a=r.nodeName&&r.nodeName.lastIndexOf(".");if(a!==void 0&&a!==-1){let n=r.nodeName.substring(a+1);sx.indexOf(n)!==-1&&(r.nodeName=r.nodeName.substring(0,a),r.objectName=n)}if(r.propertyName===null||r.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return r}static findNode(t,i){if(i===void 0||i===""||i==="."||i===-1||i===t.name||i===t.uuid)return t;if(t.skeleton){let r=t.skeleton.getBoneByName(i);if(r!==void 0)return r}if(t.children){let r=function(n){for(let s=0;s<n.length;s++){let o=n[s];if(o.name===i||o.uuid===i)return o;let l=r(o.children);if(l)return l}return null},a=r(t.children);if(a)return a}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,i){t[i]=this.targetObject[this.propertyName]}_getValue_array(t,i){let r=this.resolvedProperty;for(let a=0,n=r.length;a!==n;++a)t[i++]=r[a]}_getValue_arrayElement(t,i){t[i]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,i){this.resolvedProperty.toArray(t,i)}_setValue_direct(t,i){this.targetObject[this.propertyName]=t[i]}_setValue_direct_setNeedsUpdate(t,i){this.targetObject[this.propertyName]=t[i],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,i){this.targetObject[this.propertyName]=t[i],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,i){let r=this.resolvedProperty;for(let a=0,n=r.length;a!==n;++a)r[a]=t[i++]}_setValue_array_setNeedsUpdate(t,i){let r=this.resolvedProperty;for(let a=0,n=r.length;a!==n;++a)r[a]=t[i++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,i){let r=this.resolvedProperty;for(let a=0,n=r.length;a!==n;++a)r[a]=t[i++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,i){this.resolvedProperty[this.propertyIndex]=t[i]}_setValue_arrayElement_setNeedsUpdate(t,i){this.resolvedProperty[this.propertyIndex]=t[i],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,i){this.resolvedProperty[this.propertyIndex]=t[i],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,i){this.resolvedProperty.fromArray(t,i)}_setValue_fromArray_setNeedsUpdate(t,i){this.resolvedProperty.fromArray(t,i),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,i){this.resolvedProperty.fromArray(t,i),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,i){this.bind(),this.getValue(t,i)}_setValue_unbound(t,i){this.bind(),this.setValue(t,i)}bind(){let t=this.node,i=this.parsedPath,r=i.objectName,a=i.propertyName,n=i.propertyIndex;if(t||(t=Bn.findNode(this.rootNode,i.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Ye("PropertyBinding: No target node found for track: "+this.path+".");return}if(r){let h=i.objectIndex;switch(r){case"materials":if(!t.material){Ze("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Ze("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Ze("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let c=0;c<t.length;c++)if(t[c].name===h){h=c;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Ze("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Ze("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[r]===void 0){Ze("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[r]}if(h!==void 0){if(t[h]===void 0){Ze("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[h]}}let s=t[a];if(s===void 0){let h=i.nodeName;Ze("PropertyBinding: Trying to update property for track: "+h+"."+a+" but it wasn't found.",t);return}let o=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?o=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(n!==void 0){if(a==="morphTargetInfluences"){if(!t.geometry){Ze("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Ze("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[n]!==void 0&&(n=t.morphTargetDictionary[n])}l=this.BindingType.ArrayElement,this.resolvedProperty=s,this.propertyIndex=n}else s.fromArray!==void 0&&s.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=s):Array.isArray(s)?(l=this.BindingType.EntireArray,this.resolvedProperty=s):this.propertyName=a;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Jt.Composite=ox;Jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Jt.prototype.GetterByBindingType=[Jt.prototype._getValue_direct,Jt.prototype._getValue_array,Jt.prototype._getValue_arrayElement,Jt.prototype._getValue_toArray];Jt.prototype.SetterByBindingTypeAndVersioning=[[Jt.prototype._setValue_direct,Jt.prototype._setValue_direct_setNeedsUpdate,Jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_array,Jt.prototype._setValue_array_setNeedsUpdate,Jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_arrayElement,Jt.prototype._setValue_arrayElement_setNeedsUpdate,Jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_fromArray,Jt.prototype._setValue_fromArray_setNeedsUpdate,Jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var sb=new Float32Array(1),$f=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=st(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(st(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}},ob=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,r){let a=this.elements;return a[0]=e,a[2]=t,a[1]=i,a[3]=r,this}},mm=class extends Rv{constructor(e=10,t=10,i=4473924,r=8947848){i=new lt(i),r=new lt(r);let a=t/2,n=e/t,s=e/2,o=[],l=[];for(let d=0,u=0,f=-s;d<=t;d++,f+=n){o.push(-s,0,f,s,0,f),o.push(f,0,-s,f,0,s);let _=d===a?i:r;_.toArray(l,u),u+=3,_.toArray(l,u),u+=3,_.toArray(l,u),u+=3,_.toArray(l,u),u+=3}let h=new pi;h.setAttribute("position",new Ai(o,3)),h.setAttribute("color",new Ai(l,3));let c=new im({vertexColors:!0,toneMapped:!1});super(h,c),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}},lb=new X;var lx=class extends Ra{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Kf(e,t,i,r){let a=hx(r);switch(i){case Op:return e*t;case kp:return e*t/a.components*a.byteLength;case zc:return e*t/a.components*a.byteLength;case Ja:return e*t*2/a.components*a.byteLength;case Hc:return e*t*2/a.components*a.byteLength;case Fp:return e*t*3/a.components*a.byteLength;case zr:return e*t*4/a.components*a.byteLength;case Gc:return e*t*4/a.components*a.byteLength;case jo:case Xo:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*8;case Yo:case qo:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*16;case ac:case sc:return Math.max(e,16)*Math.max(t,8)/4;case rc:case nc:return Math.max(e,8)*Math.max(t,8)/2;case oc:case lc:case cc:case uc:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*8;case hc:case Qo:case dc:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*16;case fc:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*16;case pc:return Math.floor((e+4)/5)*Math.floor((t+3)/4)*16;case mc:return Math.floor((e+4)/5)*Math.floor((t+4)/5)*16;case gc:return Math.floor((e+5)/6)*Math.floor((t+4)/5)*16;case _c:return Math.floor((e+5)/6)*Math.floor((t+5)/6)*16;case vc:return Math.floor((e+7)/8)*Math.floor((t+4)/5)*16;case xc:return Math.floor((e+7)/8)*Math.floor((t+5)/6)*16;case Mc:return Math.floor((e+7)/8)*Math.floor((t+7)/8)*16;case Sc:return Math.floor((e+9)/10)*Math.floor((t+4)/5)*16;case yc:return Math.floor((e+9)/10)*Math.floor((t+5)/6)*16;case Ec:return Math.floor((e+9)/10)*Math.floor((t+7)/8)*16;case bc:return Math.floor((e+9)/10)*Math.floor((t+9)/10)*16;case wc:return Math.floor((e+11)/12)*Math.floor((t+9)/10)*16;case Tc:return Math.floor((e+11)/12)*Math.floor((t+11)/12)*16;case Ac:case Rc:case Cc:return Math.ceil(e/4)*Math.ceil(t/4)*16;case Pc:case Lc:return Math.ceil(e/4)*Math.ceil(t/4)*8;case el:case Dc:return Math.ceil(e/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${i} format.`)}function hx(e){switch(e){case hr:case Dp:return{byteLength:1,components:1};case Ns:case Np:case Vr:return{byteLength:2,components:1};case kc:case Bc:return{byteLength:2,components:4};case Gr:case Fc:case Br:return{byteLength:4,components:1};case Ip:case Up:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${e}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ye("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function gm(){let e=null,t=!1,i=null,r=null;function a(n,s){r=e.requestAnimationFrame(a),i(n,s)}return{start:function(){t!==!0&&i!==null&&e!==null&&(r=e.requestAnimationFrame(a),t=!0)},stop:function(){e!==null&&e.cancelAnimationFrame(r),t=!1},setAnimationLoop:function(n){i=n},setContext:function(n){e=n}}}function cx(e){let t=new WeakMap;function i(o,l){let h=o.array,c=o.usage,d=h.byteLength,u=e.createBuffer();e.bindBuffer(l,u),e.bufferData(l,h,c),o.onUploadCallback();let f;if(h instanceof Float32Array)f=e.FLOAT;else if(typeof Float16Array<"u"&&h instanceof Float16Array)f=e.HALF_FLOAT;else if(h instanceof Uint16Array)o.isFloat16BufferAttribute?f=e.HALF_FLOAT:f=e.UNSIGNED_SHORT;else if(h instanceof Int16Array)f=e.SHORT;else if(h instanceof Uint32Array)f=e.UNSIGNED_INT;else if(h instanceof Int32Array)f=e.INT;else if(h instanceof Int8Array)f=e.BYTE;else if(h instanceof Uint8Array)f=e.UNSIGNED_BYTE;else if(h instanceof Uint8ClampedArray)f=e.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+h);return{buffer:u,type:f,bytesPerElement:h.BYTES_PER_ELEMENT,version:o.version,size:d}}function r(o,l,h){let c=l.array,d=l.updateRanges;if(e.bindBuffer(h,o),d.length===0)e.bufferSubData(h,0,c);else{d.sort((f,_)=>f.start-_.start);let u=0;for(let f=1;f<d.length;f++){let _=d[u],x=d[f];x.start<=_.start+_.count+1?_.count=Math.max(_.count,x.start+x.count-_.start):(++u,d[u]=x)}d.length=u+1;for(let f=0,_=d.length;f<_;f++){let x=d[f];e.bufferSubData(h,x.start*c.BYTES_PER_ELEMENT,c,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function a(o){return o.isInterleavedBufferAttribute&&(o=o.data),t.get(o)}function n(o){o.isInterleavedBufferAttribute&&(o=o.data);let l=t.get(o);l&&(e.deleteBuffer(l.buffer),t.delete(o))}function s(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let c=t.get(o);(!c||c.version<o.version)&&t.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let h=t.get(o);if(h===void 0)t.set(o,i(o,l));else if(h.version<o.version){if(h.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");r(h.buffer,o,l),h.version=o.version}}return{get:a,remove:n,update:s}}var ux=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,dx=`#ifdef USE_ALPHAHASH
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
#endif`,fx=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,px=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,mx=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,gx=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,_x=`#ifdef USE_AOMAP
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
#endif`,vx=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,xx=`#ifdef USE_BATCHING
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
#endif`,Mx=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Sx=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,yx=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Ex=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,bx=`#ifdef USE_IRIDESCENCE
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
#endif`,wx=`#ifdef USE_BUMPMAP
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
#endif`,Tx=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Ax=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Rx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Cx=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Px=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Lx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Dx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Nx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Ix=`#define PI 3.141592653589793
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
} // validated`,Ux=`vec3 transformedNormal = objectNormal;
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
#endif`,Ox=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Fx=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,kx=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Bx=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,zx="gl_FragColor = linearToOutputTexel( gl_FragColor );",Hx=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Gx=`#ifdef USE_ENVMAP
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
#endif`,Vx=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Wx=`#ifdef USE_ENVMAP
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
#endif`,jx=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Xx=`#ifdef USE_ENVMAP
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
#endif`,Yx=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,qx=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,$x=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Kx=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Jx=`#ifdef USE_GRADIENTMAP
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
}`,Zx=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Qx=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,eM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,tM=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,iM=`#ifdef USE_ENVMAP
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
#endif`,rM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,aM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,nM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,sM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,oM=`PhysicalMaterial material;
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
#endif`,lM=`uniform sampler2D dfgLUT;
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
}`,hM=`
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
#endif`,cM=`#if defined( RE_IndirectDiffuse )
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
#endif`,uM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,dM=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,fM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,pM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,mM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,gM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,_M=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,vM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,xM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,MM=`#if defined( USE_POINTS_UV )
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
#endif`,SM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,yM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,EM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,bM=`#if defined( USE_MORPHCOLORS )
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
#endif`,wM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,TM=`#ifdef USE_MORPHTARGETS
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
#endif`,AM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,RM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,CM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,PM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,LM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,DM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,NM=`#ifdef USE_NORMALMAP
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
#endif`,IM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,UM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,OM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,FM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,kM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,BM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,zM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,HM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,GM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,VM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,WM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,jM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,XM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,YM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,qM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,$M=`float getShadowMask() {
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
}`,KM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,JM=`#ifdef USE_SKINNING
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
#endif`,ZM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,QM=`#ifdef USE_SKINNING
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
#endif`,eS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,tS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,iS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,rS=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,aS=`#ifdef USE_TRANSMISSION
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
#endif`,nS=`#ifdef USE_TRANSMISSION
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
#endif`,sS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,oS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,lS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,hS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,cS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,uS=`uniform sampler2D t2D;
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
}`,dS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,fS=`uniform float backgroundBlurriness;
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
}`,pS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,mS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,gS=`#include <common>
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
}`,_S=`#if DEPTH_PACKING == 3200
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
}`,vS=`#define DISTANCE
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
}`,xS=`#define DISTANCE
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
}`,MS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,SS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,yS=`uniform float scale;
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
}`,ES=`uniform vec3 diffuse;
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
}`,bS=`#include <common>
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
}`,wS=`uniform vec3 diffuse;
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
}`,TS=`#define LAMBERT
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
}`,AS=`#define LAMBERT
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
}`,RS=`#define MATCAP
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
}`,CS=`#define MATCAP
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
}`,PS=`#define NORMAL
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
}`,LS=`#define NORMAL
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
}`,DS=`#define PHONG
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
}`,NS=`#define PHONG
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
}`,IS=`#define STANDARD
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
}`,US=`#define STANDARD
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
}`,OS=`#define TOON
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
}`,FS=`#define TOON
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
}`,kS=`uniform float size;
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
}`,BS=`uniform vec3 diffuse;
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
}`,zS=`#include <common>
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
}`,HS=`uniform vec3 color;
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
}`,GS=`uniform float rotation;
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
}`,VS=`uniform vec3 diffuse;
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
}`,it={alphahash_fragment:ux,alphahash_pars_fragment:dx,alphamap_fragment:fx,alphamap_pars_fragment:px,alphatest_fragment:mx,alphatest_pars_fragment:gx,aomap_fragment:_x,aomap_pars_fragment:vx,batching_pars_vertex:xx,batching_vertex:Mx,begin_vertex:Sx,beginnormal_vertex:yx,bsdfs:Ex,iridescence_fragment:bx,bumpmap_pars_fragment:wx,clipping_planes_fragment:Tx,clipping_planes_pars_fragment:Ax,clipping_planes_pars_vertex:Rx,clipping_planes_vertex:Cx,color_fragment:Px,color_pars_fragment:Lx,color_pars_vertex:Dx,color_vertex:Nx,common:Ix,defaultnormal_vertex:Ux,displacementmap_pars_vertex:Ox,displacementmap_vertex:Fx,emissivemap_fragment:kx,emissivemap_pars_fragment:Bx,colorspace_fragment:zx,colorspace_pars_fragment:Hx,envmap_fragment:Gx,envmap_common_pars_fragment:Vx,envmap_pars_fragment:Wx,envmap_pars_vertex:jx,envmap_physical_pars_fragment:iM,envmap_vertex:Xx,fog_vertex:Yx,fog_pars_vertex:qx,fog_fragment:$x,fog_pars_fragment:Kx,gradientmap_pars_fragment:Jx,lightmap_pars_fragment:Zx,lights_lambert_fragment:Qx,lights_lambert_pars_fragment:eM,lights_pars_begin:tM,lights_toon_fragment:rM,lights_toon_pars_fragment:aM,lights_phong_fragment:nM,lights_phong_pars_fragment:sM,lights_physical_fragment:oM,lights_physical_pars_fragment:lM,lights_fragment_begin:hM,lights_fragment_maps:cM,lights_fragment_end:uM,lightprobes_pars_fragment:dM,logdepthbuf_fragment:fM,logdepthbuf_pars_fragment:pM,logdepthbuf_pars_vertex:mM,logdepthbuf_vertex:gM,map_fragment:_M,map_pars_fragment:vM,map_particle_fragment:xM,map_particle_pars_fragment:MM,metalnessmap_fragment:SM,metalnessmap_pars_fragment:yM,morphinstance_vertex:EM,morphcolor_vertex:bM,morphnormal_vertex:wM,morphtarget_pars_vertex:TM,morphtarget_vertex:AM,normal_fragment_begin:RM,normal_fragment_maps:CM,normal_pars_fragment:PM,normal_pars_vertex:LM,normal_vertex:DM,normalmap_pars_fragment:NM,clearcoat_normal_fragment_begin:IM,clearcoat_normal_fragment_maps:UM,clearcoat_pars_fragment:OM,iridescence_pars_fragment:FM,opaque_fragment:kM,packing:BM,premultiplied_alpha_fragment:zM,project_vertex:HM,dithering_fragment:GM,dithering_pars_fragment:VM,roughnessmap_fragment:WM,roughnessmap_pars_fragment:jM,shadowmap_pars_fragment:XM,shadowmap_pars_vertex:YM,shadowmap_vertex:qM,shadowmask_pars_fragment:$M,skinbase_vertex:KM,skinning_pars_vertex:JM,skinning_vertex:ZM,skinnormal_vertex:QM,specularmap_fragment:eS,specularmap_pars_fragment:tS,tonemapping_fragment:iS,tonemapping_pars_fragment:rS,transmission_fragment:aS,transmission_pars_fragment:nS,uv_pars_fragment:sS,uv_pars_vertex:oS,uv_vertex:lS,worldpos_vertex:hS,background_vert:cS,background_frag:uS,backgroundCube_vert:dS,backgroundCube_frag:fS,cube_vert:pS,cube_frag:mS,depth_vert:gS,depth_frag:_S,distance_vert:vS,distance_frag:xS,equirect_vert:MS,equirect_frag:SS,linedashed_vert:yS,linedashed_frag:ES,meshbasic_vert:bS,meshbasic_frag:wS,meshlambert_vert:TS,meshlambert_frag:AS,meshmatcap_vert:RS,meshmatcap_frag:CS,meshnormal_vert:PS,meshnormal_frag:LS,meshphong_vert:DS,meshphong_frag:NS,meshphysical_vert:IS,meshphysical_frag:US,meshtoon_vert:OS,meshtoon_frag:FS,points_vert:kS,points_frag:BS,shadow_vert:zS,shadow_frag:HS,sprite_vert:GS,sprite_frag:VS},Pe={common:{diffuse:{value:new lt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new et}},envmap:{envMap:{value:null},envMapRotation:{value:new et},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new et}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new et}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new et},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new et},normalScale:{value:new rt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new et},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new et}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new et}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new et}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new lt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new lt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0},uvTransform:{value:new et}},sprite:{diffuse:{value:new lt(16777215)},opacity:{value:1},center:{value:new rt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}}},kr={basic:{uniforms:ki([Pe.common,Pe.specularmap,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.fog]),vertexShader:it.meshbasic_vert,fragmentShader:it.meshbasic_frag},lambert:{uniforms:ki([Pe.common,Pe.specularmap,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.fog,Pe.lights,{emissive:{value:new lt(0)},envMapIntensity:{value:1}}]),vertexShader:it.meshlambert_vert,fragmentShader:it.meshlambert_frag},phong:{uniforms:ki([Pe.common,Pe.specularmap,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.fog,Pe.lights,{emissive:{value:new lt(0)},specular:{value:new lt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:it.meshphong_vert,fragmentShader:it.meshphong_frag},standard:{uniforms:ki([Pe.common,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.roughnessmap,Pe.metalnessmap,Pe.fog,Pe.lights,{emissive:{value:new lt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:it.meshphysical_vert,fragmentShader:it.meshphysical_frag},toon:{uniforms:ki([Pe.common,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.gradientmap,Pe.fog,Pe.lights,{emissive:{value:new lt(0)}}]),vertexShader:it.meshtoon_vert,fragmentShader:it.meshtoon_frag},matcap:{uniforms:ki([Pe.common,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.fog,{matcap:{value:null}}]),vertexShader:it.meshmatcap_vert,fragmentShader:it.meshmatcap_frag},points:{uniforms:ki([Pe.points,Pe.fog]),vertexShader:it.points_vert,fragmentShader:it.points_frag},dashed:{uniforms:ki([Pe.common,Pe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:it.linedashed_vert,fragmentShader:it.linedashed_frag},depth:{uniforms:ki([Pe.common,Pe.displacementmap]),vertexShader:it.depth_vert,fragmentShader:it.depth_frag},normal:{uniforms:ki([Pe.common,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,{opacity:{value:1}}]),vertexShader:it.meshnormal_vert,fragmentShader:it.meshnormal_frag},sprite:{uniforms:ki([Pe.sprite,Pe.fog]),vertexShader:it.sprite_vert,fragmentShader:it.sprite_frag},background:{uniforms:{uvTransform:{value:new et},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:it.background_vert,fragmentShader:it.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new et}},vertexShader:it.backgroundCube_vert,fragmentShader:it.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:it.cube_vert,fragmentShader:it.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:it.equirect_vert,fragmentShader:it.equirect_frag},distance:{uniforms:ki([Pe.common,Pe.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:it.distance_vert,fragmentShader:it.distance_frag},shadow:{uniforms:ki([Pe.lights,Pe.fog,{color:{value:new lt(0)},opacity:{value:1}}]),vertexShader:it.shadow_vert,fragmentShader:it.shadow_frag}};kr.physical={uniforms:ki([kr.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new et},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new et},clearcoatNormalScale:{value:new rt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new et},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new et},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new et},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new et},sheen:{value:0},sheenColor:{value:new lt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new et},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new et},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new et},transmissionSamplerSize:{value:new rt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new et},attenuationDistance:{value:0},attenuationColor:{value:new lt(0)},specularColor:{value:new lt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new et},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new et},anisotropyVector:{value:new rt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new et}}]),vertexShader:it.meshphysical_vert,fragmentShader:it.meshphysical_frag};var Ho={r:0,b:0,g:0},WS=new ti,_m=new et;_m.set(-1,0,0,0,1,0,0,0,1);function jS(e,t,i,r,a,n){let s=new lt(0),o=a===!0?0:1,l,h,c=null,d=0,u=null;function f(w){let R=w.isScene===!0?w.background:null;if(R&&R.isTexture){let E=w.backgroundBlurriness>0;R=t.get(R,E)}return R}function _(w){let R=!1,E=f(w);E===null?p(s,o):E&&E.isColor&&(p(E,1),R=!0);let T=e.xr.getEnvironmentBlendMode();T==="additive"?i.buffers.color.setClear(0,0,0,1,n):T==="alpha-blend"&&i.buffers.color.setClear(0,0,0,0,n),(e.autoClear||R)&&(i.buffers.depth.setTest(!0),i.buffers.depth.setMask(!0),i.buffers.color.setMask(!0),e.clear(e.autoClearColor,e.autoClearDepth,e.autoClearStencil))}function x(w,R){let E=f(R);E&&E.isCubeTexture?(h===void 0&&(h=new Di(new qc(1,1,1),new Bi({name:"BackgroundCubeMaterial",uniforms:qn(kr.backgroundCube.uniforms),vertexShader:kr.backgroundCube.vertexShader,fragmentShader:kr.backgroundCube.fragmentShader,side:Vi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(T,P,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),r.update(h)),h.material.uniforms.envMap.value=E,h.material.uniforms.backgroundBlurriness.value=R.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=R.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(WS.makeRotationFromEuler(R.backgroundRotation)).transpose(),E.isRenderTargetTexture===!1&&h.material.uniforms.backgroundRotation.value.premultiply(_m),h.material.toneMapped=ft.getTransfer(E.colorSpace)!==Pt,(c!==E||d!==E.version||u!==e.toneMapping)&&(h.material.needsUpdate=!0,c=E,d=E.version,u=e.toneMapping),h.layers.enableAll(),w.unshift(h,h.geometry,h.material,0,0,null)):E&&E.isTexture&&(l===void 0&&(l=new Di(new lm(2,2),new Bi({name:"BackgroundMaterial",uniforms:qn(kr.background.uniforms),vertexShader:kr.background.vertexShader,fragmentShader:kr.background.fragmentShader,side:Ka,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),r.update(l)),l.material.uniforms.t2D.value=E,l.material.uniforms.backgroundIntensity.value=R.backgroundIntensity,l.material.toneMapped=ft.getTransfer(E.colorSpace)!==Pt,E.matrixAutoUpdate===!0&&E.updateMatrix(),l.material.uniforms.uvTransform.value.copy(E.matrix),(c!==E||d!==E.version||u!==e.toneMapping)&&(l.material.needsUpdate=!0,c=E,d=E.version,u=e.toneMapping),l.layers.enableAll(),w.unshift(l,l.geometry,l.material,0,0,null))}function p(w,R){w.getRGB(Ho,cm(e)),i.buffers.color.setClear(Ho.r,Ho.g,Ho.b,R,n)}function m(){h!==void 0&&(h.geometry.dispose(),h.material.dispose(),h=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return s},setClearColor:function(w,R=1){s.set(w),o=R,p(s,o)},getClearAlpha:function(){return o},setClearAlpha:function(w){o=w,p(s,o)},render:_,addToRenderList:x,dispose:m}}function XS(e,t){let i=e.getParameter(e.MAX_VERTEX_ATTRIBS),r={},a=u(null),n=a,s=!1;function o(N,B,I,L,G){let Z=!1,O=d(N,L,I,B);n!==O&&(n=O,h(n.object)),Z=f(N,L,I,G),Z&&_(N,L,I,G),G!==null&&t.update(G,e.ELEMENT_ARRAY_BUFFER),(Z||s)&&(s=!1,E(N,B,I,L),G!==null&&e.bindBuffer(e.ELEMENT_ARRAY_BUFFER,t.get(G).buffer))}function l(){return e.createVertexArray()}function h(N){return e.bindVertexArray(N)}function c(N){return e.deleteVertexArray(N)}function d(N,B,I,L){let G=L.wireframe===!0,Z=r[B.id];Z===void 0&&(Z={},r[B.id]=Z);let O=N.isInstancedMesh===!0?N.id:0,de=Z[O];de===void 0&&(de={},Z[O]=de);let J=de[I.id];J===void 0&&(J={},de[I.id]=J);let te=J[G];return te===void 0&&(te=u(l()),J[G]=te),te}function u(N){let B=[],I=[],L=[];for(let G=0;G<i;G++)B[G]=0,I[G]=0,L[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:I,attributeDivisors:L,object:N,attributes:{},index:null}}function f(N,B,I,L){let G=n.attributes,Z=B.attributes,O=0,de=I.getAttributes();for(let J in de)if(de[J].location>=0){let te=G[J],ne=Z[J];if(ne===void 0&&(J==="instanceMatrix"&&N.instanceMatrix&&(ne=N.instanceMatrix),J==="instanceColor"&&N.instanceColor&&(ne=N.instanceColor)),te===void 0||te.attribute!==ne||ne&&te.data!==ne.data)return!0;O++}return n.attributesNum!==O||n.index!==L}function _(N,B,I,L){let G={},Z=B.attributes,O=0,de=I.getAttributes();for(let J in de)if(de[J].location>=0){let te=Z[J];te===void 0&&(J==="instanceMatrix"&&N.instanceMatrix&&(te=N.instanceMatrix),J==="instanceColor"&&N.instanceColor&&(te=N.instanceColor));let ne={};ne.attribute=te,te&&te.data&&(ne.data=te.data),G[J]=ne,O++}n.attributes=G,n.attributesNum=O,n.index=L}function x(){let N=n.newAttributes;for(let B=0,I=N.length;B<I;B++)N[B]=0}function p(N){m(N,0)}function m(N,B){let I=n.newAttributes,L=n.enabledAttributes,G=n.attributeDivisors;I[N]=1,L[N]===0&&(e.enableVertexAttribArray(N),L[N]=1),G[N]!==B&&(e.vertexAttribDivisor(N,B),G[N]=B)}function w(){let N=n.newAttributes,B=n.enabledAttributes;for(let I=0,L=B.length;I<L;I++)B[I]!==N[I]&&(e.disableVertexAttribArray(I),B[I]=0)}function R(N,B,I,L,G,Z,O){O===!0?e.vertexAttribIPointer(N,B,I,G,Z):e.vertexAttribPointer(N,B,I,L,G,Z)}function E(N,B,I,L){x();let G=L.attributes,Z=I.getAttributes(),O=B.defaultAttributeValues;for(let de in Z){let J=Z[de];if(J.location>=0){let te=G[de];if(te===void 0&&(de==="instanceMatrix"&&N.instanceMatrix&&(te=N.instanceMatrix),de==="instanceColor"&&N.instanceColor&&(te=N.instanceColor)),te!==void 0){let ne=te.normalized,Le=te.itemSize,K=t.get(te);if(K===void 0)continue;let re=K.buffer,se=K.type,Ce=K.bytesPerElement,Re=se===e.INT||se===e.UNSIGNED_INT||te.gpuType===Fc;if(te.isInterleavedBufferAttribute){let le=te.data,Fe=le.isInterleavedBuffer===!0?le.stride:le.itemSize,We=te.offset;if(le.isInstancedInterleavedBuffer||le.isInstancedBufferAttribute){for(let we=0;we<J.locationSize;we++)m(J.location+we,le.meshPerAttribute);N.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=le.meshPerAttribute*le.count)}else for(let we=0;we<J.locationSize;we++)p(J.location+we);e.bindBuffer(e.ARRAY_BUFFER,re);for(let we=0;we<J.locationSize;we++)R(J.location+we,Le/J.locationSize,se,ne,Fe*Ce,(We+Le/J.locationSize*we)*Ce,Re)}else{if(te.isInstancedBufferAttribute){for(let le=0;le<J.locationSize;le++)m(J.location+le,te.meshPerAttribute);N.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=te.meshPerAttribute*te.count)}else for(let le=0;le<J.locationSize;le++)p(J.location+le);e.bindBuffer(e.ARRAY_BUFFER,re);for(let le=0;le<J.locationSize;le++)R(J.location+le,Le/J.locationSize,se,ne,Le*Ce,Le/J.locationSize*le*Ce,Re)}}else if(O!==void 0){let ne=O[de];if(ne!==void 0)switch(ne.length){case 2:e.vertexAttrib2fv(J.location,ne);break;case 3:e.vertexAttrib3fv(J.location,ne);break;case 4:e.vertexAttrib4fv(J.location,ne);break;default:e.vertexAttrib1fv(J.location,ne)}}}}w()}function T(){U();for(let N in r){let B=r[N];for(let I in B){let L=B[I];for(let G in L){let Z=L[G];for(let O in Z)c(Z[O].object),delete Z[O];delete L[G]}}delete r[N]}}function P(N){if(r[N.id]===void 0)return;let B=r[N.id];for(let I in B){let L=B[I];for(let G in L){let Z=L[G];for(let O in Z)c(Z[O].object),delete Z[O];delete L[G]}}delete r[N.id]}function v(N){for(let B in r){let I=r[B];for(let L in I){let G=I[L];if(G[N.id]===void 0)continue;let Z=G[N.id];for(let O in Z)c(Z[O].object),delete Z[O];delete G[N.id]}}}function b(N){for(let B in r){let I=r[B],L=N.isInstancedMesh===!0?N.id:0,G=I[L];if(G!==void 0){for(let Z in G){let O=G[Z];for(let de in O)c(O[de].object),delete O[de];delete G[Z]}delete I[L],Object.keys(I).length===0&&delete r[B]}}}function U(){W(),s=!0,n!==a&&(n=a,h(n.object))}function W(){a.geometry=null,a.program=null,a.wireframe=!1}return{setup:o,reset:U,resetDefaultState:W,dispose:T,releaseStatesOfGeometry:P,releaseStatesOfObject:b,releaseStatesOfProgram:v,initAttributes:x,enableAttribute:p,disableUnusedAttributes:w}}function YS(e,t,i){let r;function a(l){r=l}function n(l,h){e.drawArrays(r,l,h),i.update(h,r,1)}function s(l,h,c){c!==0&&(e.drawArraysInstanced(r,l,h,c),i.update(h,r,c))}function o(l,h,c){if(c===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(r,l,0,h,0,c);let d=0;for(let u=0;u<c;u++)d+=h[u];i.update(d,r,1)}this.setMode=a,this.render=n,this.renderInstances=s,this.renderMultiDraw=o}function qS(e,t,i,r){let a;function n(){if(a!==void 0)return a;if(t.has("EXT_texture_filter_anisotropic")===!0){let v=t.get("EXT_texture_filter_anisotropic");a=e.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else a=0;return a}function s(v){return!(v!==zr&&r.convert(v)!==e.getParameter(e.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(v){let b=v===Vr&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(v!==hr&&v!==Br&&!b&&r.convert(v)!==e.getParameter(e.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(e.getShaderPrecisionFormat(e.VERTEX_SHADER,e.HIGH_FLOAT).precision>0&&e.getShaderPrecisionFormat(e.FRAGMENT_SHADER,e.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&e.getShaderPrecisionFormat(e.VERTEX_SHADER,e.MEDIUM_FLOAT).precision>0&&e.getShaderPrecisionFormat(e.FRAGMENT_SHADER,e.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let h=i.precision!==void 0?i.precision:"highp",c=l(h);c!==h&&(Ye("WebGLRenderer:",h,"not supported, using",c,"instead."),h=c);let d=i.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=i.logarithmicDepthBuffer===!0&&d===!1;i.reversedDepthBuffer===!0&&d===!1&&Ye("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),i.logarithmicDepthBuffer===!0&&d===!0&&Ye("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=e.getParameter(e.MAX_TEXTURE_IMAGE_UNITS),_=e.getParameter(e.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=e.getParameter(e.MAX_TEXTURE_SIZE),p=e.getParameter(e.MAX_CUBE_MAP_TEXTURE_SIZE),m=e.getParameter(e.MAX_VERTEX_ATTRIBS),w=e.getParameter(e.MAX_VERTEX_UNIFORM_VECTORS),R=e.getParameter(e.MAX_VARYING_VECTORS),E=e.getParameter(e.MAX_FRAGMENT_UNIFORM_VECTORS),T=e.getParameter(e.MAX_SAMPLES),P=e.getParameter(e.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:n,getMaxPrecision:l,textureFormatReadable:s,textureTypeReadable:o,precision:h,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:_,maxTextureSize:x,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:w,maxVaryings:R,maxFragmentUniforms:E,maxSamples:T,samples:P}}function $S(e){let t=this,i=null,r=0,a=!1,n=!1,s=new ia,o=new et,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let f=d.length!==0||u||r!==0||a;return a=u,r=d.length,f},this.beginShadows=function(){n=!0,c(null)},this.endShadows=function(){n=!1},this.setGlobalState=function(d,u){i=c(d,u,0)},this.setState=function(d,u,f){let _=d.clippingPlanes,x=d.clipIntersection,p=d.clipShadows,m=e.get(d);if(!a||_===null||_.length===0||n&&!p)n?c(null):h();else{let w=n?0:r,R=w*4,E=m.clippingState||null;l.value=E,E=c(_,u,R,f);for(let T=0;T!==R;++T)E[T]=i[T];m.clippingState=E,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=w}};function h(){l.value!==i&&(l.value=i,l.needsUpdate=r>0),t.numPlanes=r,t.numIntersection=0}function c(d,u,f,_){let x=d!==null?d.length:0,p=null;if(x!==0){if(p=l.value,_!==!0||p===null){let m=f+x*4,w=u.matrixWorldInverse;o.getNormalMatrix(w),(p===null||p.length<m)&&(p=new Float32Array(m));for(let R=0,E=f;R!==x;++R,E+=4)s.copy(d[R]).applyMatrix4(w,o),s.normal.toArray(p,E),p[E+3]=s.constant}l.value=p,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,p}}var Jc=class extends Hr{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},r=[i,i,i,i,i,i];this.texture=new am(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new qc(5,5,5),a=new Bi({name:"CubemapFromEquirect",uniforms:qn(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Vi,blending:Gn});a.uniforms.tEquirect.value=t;let n=new Di(r,a),s=t.minFilter;return t.minFilter===wa&&(t.minFilter=Gi),new Uc(1,10,this).update(e,n),t.minFilter=s,n.geometry.dispose(),n.material.dispose(),this}clear(e,t=!0,i=!0,r=!0){let a=e.getRenderTarget();for(let n=0;n<6;n++)e.setRenderTarget(this,n),e.clear(t,i,r);e.setRenderTarget(a)}},Jf=256,KS=3,JS=20,vm=256,xm=16,ZS=3,QS=new X,e1=new lt,Zf=class Mm{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Uc(1,10,null),this._boxMesh=new Di(new qc(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,i=0,r=.1,a=100,n={}){let{size:s=256,position:o=QS}=n,l=this._renderer;this._setSize(s);let h=this._allocateTarget(),c=this._getSourceTarget(!0);i>0&&(c.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,f=l.autoClearDepth,_=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(e1));let p=new Uc(r,a,c);return p.position.copy(o),p.update(l,t),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=f,l.autoClearStencil=_,t.background=x,i>0&&(c.texture.mipmapsAutoUpdate=!0,this._blur(h,i)),this._applyPMREM(h),h}fromEquirectangular(t,i=null){return this._fromTexture(t,i)}fromCubemap(t,i=null){return this._fromTexture(t,i)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=tp(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=ep(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,i){return i>0?1-Math.sqrt(1-t/i):0}_setSize(t){this._cubeSize=Math.max(Jf,Vp(t))}_fromTexture(t,i){t.mapping===Wn||t.mapping===Ds?this._setSize(t.image.length===0?Jf:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let r=i||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(r),r}_allocateTarget(){let t=this._cubeSize,i=Qf(t,!1,!1),r=Math.log2(t)-KS;for(let a=0;a<=r;a++)i.texture.mipmaps.push({width:t>>a,height:t>>a});return i.texture.name="PMREM",i.texture.isPMREMTexture=!0,i}_getSourceTarget(t=!1){let i=this._cubeSize,r=this._sourceTarget;return(r===null||r.width!==i||t&&r.depthBuffer===!1)&&(r!==null&&r.dispose(),this._sourceTarget=Qf(i,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,i,r){let a=this._boxMesh,n=this._cubeCamera;a.material=r,n.renderTarget=t,n.activeMipmapLevel=i;let s=t.width>>i;t.viewport.set(0,0,s,s),n.update(this._renderer,a),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let i;t.mapping===Wn||t.mapping===Ds?(this._cubemapMaterial===null&&(this._cubemapMaterial=tp()),i=this._cubemapMaterial,i.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=ep()),i=this._equirectMaterial),i.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,i)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=t1(),this._integrationMaterial=i1());let i=this._cubeSize,r=t.texture.mipmaps.length-1,a=this._ggxMaterial.uniforms;a.envMap.value=this._sourceTarget.texture;let n=this._integrationMaterial.uniforms;n.envMap.value=this._sourceTarget.texture,n.sourceLod.value=Math.log2(i/xm);for(let s=0;s<=r;s++){let o=Mm.lodToRoughness(s,r);if(s>r-ZS)n.roughness.value=o,this._renderCube(t,s,this._integrationMaterial);else{let l=o>0?Math.log2(i)+.5*Math.log2(6/(vm*Math.pow(o,4)))+.5:0;a.roughness.value=o,a.lodBias.value=l,this._renderCube(t,s,this._ggxMaterial)}}}_blur(t,i){this._blurMaterial===null&&(this._blurMaterial=r1());let r=this._blurMaterial,a=r.uniforms,n=this._sourceTarget;a.sigma.value=Math.min(i,Math.PI)/Math.SQRT2,a.envMap.value=n.texture,this._renderCube(t,0,r),a.envMap.value=t.texture,this._renderCube(n,0,r)}};function Qf(e,t,i){return new Jc(e,{minFilter:wa,generateMipmaps:t,type:Vr,colorSpace:il,depthBuffer:i})}function zs(e,t,i){return new Bi({name:e,uniforms:t,vertexShader:it.cube_vert,fragmentShader:i,side:Vi,blending:Gn,depthTest:!1,depthWrite:!1})}function t1(){return zs("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${vm}u

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
	`)}function i1(){return zs("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:xm}},`

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
	`)}function r1(){return zs("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${JS}
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
	`)}function ep(){return zs("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function tp(){return zs("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function a1(e){let t=new WeakMap,i=new WeakMap,r=null;function a(u,f=!1){return u==null?null:f?s(u):n(u)}function n(u){if(u&&u.isTexture){let f=u.mapping;if(f===xh||f===Mh)if(t.has(u)){let _=t.get(u).texture;return o(_,u.mapping)}else{let _=u.image;if(_&&_.height>0){let x=new Jc(_.height);return x.fromEquirectangularTexture(e,u),t.set(u,x),u.addEventListener("dispose",h),o(x.texture,u.mapping)}else return null}}return u}function s(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let f=u.mapping,_=f===xh||f===Mh,x=f===Wn||f===Ds;if(_||x){let p=i.get(u),m=p!==void 0?p.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==m)return r===null&&(r=new Zf(e)),p=_?r.fromEquirectangular(u,p):r.fromCubemap(u,p),p.texture.pmremVersion=u.pmremVersion,i.set(u,p),p.texture;if(p!==void 0)return p.texture;{let w=u.image;return _&&w&&w.height>0||x&&w&&l(w)?(r===null&&(r=new Zf(e)),p=_?r.fromEquirectangular(u):r.fromCubemap(u),p.texture.pmremVersion=u.pmremVersion,i.set(u,p),u.addEventListener("dispose",c),p.texture):null}}}return u}function o(u,f){return f===xh?u.mapping=Wn:f===Mh&&(u.mapping=Ds),u}function l(u){let f=0,_=6;for(let x=0;x<_;x++)u[x]!==void 0&&f++;return f===_}function h(u){let f=u.target;f.removeEventListener("dispose",h);let _=t.get(f);_!==void 0&&(t.delete(f),_.dispose())}function c(u){let f=u.target;f.removeEventListener("dispose",c);let _=i.get(f);_!==void 0&&(i.delete(f),_.dispose())}function d(){t=new WeakMap,i=new WeakMap,r!==null&&(r.dispose(),r=null)}return{get:a,dispose:d}}function n1(e){let t={};function i(r){if(t[r]!==void 0)return t[r];let a=e.getExtension(r);return t[r]=a,a}return{has:function(r){return i(r)!==null},init:function(){i("EXT_color_buffer_float"),i("WEBGL_clip_cull_distance"),i("OES_texture_float_linear"),i("EXT_color_buffer_half_float"),i("WEBGL_multisampled_render_to_texture"),i("WEBGL_render_shared_exponent")},get:function(r){let a=i(r);return a===null&&$o("WebGLRenderer: "+r+" extension not supported."),a}}}function s1(e,t,i,r){let a={},n=new WeakMap,s=new FinalizationRegistry(_=>delete a[_]);function o(_){l(_.target)}function l(_){_.index!==null&&t.remove(_.index);for(let p in _.attributes)t.remove(_.attributes[p]);_.removeEventListener("dispose",o),delete a[_.id],s.unregister(_);let x=n.get(_);x&&(t.remove(x),n.delete(_)),r.releaseStatesOfGeometry(_),_.isInstancedBufferGeometry===!0&&delete _._maxInstanceCount,i.memory.geometries--}function h(_,x){return a[x.id]!==void 0||(x.addEventListener("dispose",o),a[x.id]=new WeakRef(x),s.register(x,x.id,x),i.memory.geometries++),x}function c(_){let x=_.attributes;for(let p in x)t.update(x[p],e.ARRAY_BUFFER)}function d(_){let x=_.index,p=_.attributes.position,m=0;if(p===void 0)return;let w=x!==null?x.array.length:p.array.length/3-1,R=p.count>=65535?Qp:Zp,E=new R(Math.ceil(w/3)*6,1),T=E.array;if(x!==null){let v=x.array;m=x.version;for(let b=0,U=0;b<w;b+=3){let W=v[b+0],N=v[b+1],B=v[b+2];T[U++]=W,T[U++]=N,T[U++]=N,T[U++]=B,T[U++]=B,T[U++]=W}}else{m=p.version;for(let v=0,b=0;v<w;v+=3){let U=v+0,W=v+1,N=v+2;T[b++]=U,T[b++]=W,T[b++]=W,T[b++]=N,T[b++]=N,T[b++]=U}}E.version=m;let P=n.get(_);P&&t.remove(P),n.set(_,E)}function u(_){let x=n.get(_);if(x){let p=_.index;p!==null&&x.version<p.version&&d(_)}else d(_);return n.get(_)}function f(){for(let _ in a){let x=a[_].deref();x!==void 0&&l(x)}}return{get:h,update:c,getWireframeAttribute:u,dispose:f}}function o1(e,t,i){let r;function a(d){r=d}let n,s;function o(d){n=d.type,s=d.bytesPerElement}function l(d,u){e.drawElements(r,u,n,d*s),i.update(u,r,1)}function h(d,u,f){f!==0&&(e.drawElementsInstanced(r,u,n,d*s,f),i.update(u,r,f))}function c(d,u,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(r,u,0,n,d,0,f);let _=0;for(let x=0;x<f;x++)_+=u[x];i.update(_,r,1)}this.setMode=a,this.setIndex=o,this.render=l,this.renderInstances=h,this.renderMultiDraw=c}function l1(e){let t={geometries:0,textures:0},i={frame:0,calls:0,triangles:0,points:0,lines:0};function r(n,s,o){switch(i.calls++,s){case e.TRIANGLES:i.triangles+=o*(n/3);break;case e.LINES:i.lines+=o*(n/2);break;case e.LINE_STRIP:i.lines+=o*(n-1);break;case e.LINE_LOOP:i.lines+=o*n;break;case e.POINTS:i.points+=o*n;break;default:Ze("WebGLInfo: Unknown draw mode:",s);break}}function a(){i.calls=0,i.triangles=0,i.points=0,i.lines=0}return{memory:t,render:i,programs:null,autoReset:!0,reset:a,update:r}}function h1(e,t,i){let r=new WeakMap,a=new Ft;function n(s,o,l){let h=s.morphTargetInfluences,c=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,d=c!==void 0?c.length:0,u=r.get(o);if(u===void 0||u.count!==d){let f=function(){b.dispose(),r.delete(o),o.removeEventListener("dispose",f)};u!==void 0&&u.texture.dispose();let _=o.morphAttributes.position!==void 0,x=o.morphAttributes.normal!==void 0,p=o.morphAttributes.color!==void 0,m=o.morphAttributes.position||[],w=o.morphAttributes.normal||[],R=o.morphAttributes.color||[],E=0;_===!0&&(E=1),x===!0&&(E=2),p===!0&&(E=3);let T=o.attributes.position.count*E,P=1;T>t.maxTextureSize&&(P=Math.ceil(T/t.maxTextureSize),T=t.maxTextureSize);let v=new Float32Array(T*P*4*d),b=new Xp(v,T,P,d);b.type=Br,b.needsUpdate=!0;let U=E*4;for(let W=0;W<d;W++){let N=m[W],B=w[W],I=R[W],L=T*P*4*W;for(let G=0;G<N.count;G++){let Z=G*U;_===!0&&(a.fromBufferAttribute(N,G),v[L+Z+0]=a.x,v[L+Z+1]=a.y,v[L+Z+2]=a.z,v[L+Z+3]=0),x===!0&&(a.fromBufferAttribute(B,G),v[L+Z+4]=a.x,v[L+Z+5]=a.y,v[L+Z+6]=a.z,v[L+Z+7]=0),p===!0&&(a.fromBufferAttribute(I,G),v[L+Z+8]=a.x,v[L+Z+9]=a.y,v[L+Z+10]=a.z,v[L+Z+11]=I.itemSize===4?a.w:1)}}u={count:d,texture:b,size:new rt(T,P)},r.set(o,u),o.addEventListener("dispose",f)}if(s.isInstancedMesh===!0&&s.morphTexture!==null)l.getUniforms().setValue(e,"morphTexture",s.morphTexture,i);else{let f=0;for(let x=0;x<h.length;x++)f+=h[x];let _=o.morphTargetsRelative?1:1-f;l.getUniforms().setValue(e,"morphTargetBaseInfluence",_),l.getUniforms().setValue(e,"morphTargetInfluences",h)}l.getUniforms().setValue(e,"morphTargetsTexture",u.texture,i),l.getUniforms().setValue(e,"morphTargetsTextureSize",u.size)}return{update:n}}function c1(e,t,i,r,a){let n=new WeakMap;function s(h){let c=a.render.frame,d=h.geometry,u=t.get(h,d);if(n.get(u)!==c&&(t.update(u),n.set(u,c)),h.isInstancedMesh&&(h.hasEventListener("dispose",l)===!1&&h.addEventListener("dispose",l),n.get(h)!==c&&(i.update(h.instanceMatrix,e.ARRAY_BUFFER),h.instanceColor!==null&&i.update(h.instanceColor,e.ARRAY_BUFFER),n.set(h,c))),h.isSkinnedMesh){let f=h.skeleton;n.get(f)!==c&&(f.update(),n.set(f,c))}return u}function o(){n=new WeakMap}function l(h){let c=h.target;c.removeEventListener("dispose",l),r.releaseStatesOfObject(c),i.remove(c.instanceMatrix),c.instanceColor!==null&&i.remove(c.instanceColor)}return{update:s,dispose:o}}var u1={[bp]:"LINEAR_TONE_MAPPING",[wp]:"REINHARD_TONE_MAPPING",[Tp]:"CINEON_TONE_MAPPING",[Ap]:"ACES_FILMIC_TONE_MAPPING",[Cp]:"AGX_TONE_MAPPING",[Pp]:"NEUTRAL_TONE_MAPPING",[Rp]:"CUSTOM_TONE_MAPPING"};function d1(e,t,i,r,a,n){let s=new Hr(t,i,{type:e,depthBuffer:a,stencilBuffer:n,samples:r?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,l=null,h=null,c=new pi;c.setAttribute("position",new Ai([-1,3,0,-1,-1,0,3,-1,0],3)),c.setAttribute("uv",new Ai([0,2,0,0,2,0],2));let d=new Iv({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new Di(c,d),f=new Jv(-1,1,1,-1,0,1),_=null,x=null,p=!1,m,w=null,R=[],E=!1;this.setSize=function(T,P){s.setSize(T,P),o!==null&&o.setSize(T,P),l!==null&&l.setSize(T,P);for(let v=0;v<R.length;v++){let b=R[v];b.setSize&&b.setSize(T,P)}},this.setEffects=function(T){R=T,E=R.length>0&&R[0].isRenderPass===!0;let P=s.width,v=s.height;R.length>0&&o===null&&(o=new Hr(P,v,{type:Vr,depthBuffer:!1,stencilBuffer:!1}),l=new Hr(P,v,{type:Vr,depthBuffer:!1,stencilBuffer:!1}));let b=a===!0&&R.some(U=>U.needsDepthTexture===!0);b!==(s.depthTexture!==null)&&(b===!0&&h===null&&(h=new Yn(P,v),n===!0&&(h.format=Ta,h.type=jn)),s.dispose(),s.depthTexture=b?h:null,s.resolveDepthBuffer=b,s.storeMultisampledDepthBuffer=b);for(let U=0;U<R.length;U++){let W=R[U];W.setSize&&W.setSize(P,v),b&&W.needsDepthTexture===!0&&W.setDepthTexture&&W.setDepthTexture(h)}},this.begin=function(T,P){if(p||T.toneMapping===na&&R.length===0)return!1;if(w=P,P!==null){let v=P.width,b=P.height;(s.width!==v||s.height!==b)&&this.setSize(v,b)}return E===!1&&T.setRenderTarget(s),m=T.toneMapping,T.toneMapping=na,!0},this.hasRenderPass=function(){return E},this.end=function(T,P){T.toneMapping=m,p=!0;let v=s,b=o;for(let U=0;U<R.length;U++){let W=R[U];W.enabled!==!1&&(W.render(T,b,v,P),W.needsSwap!==!1&&(v=b,b=b===o?l:o))}if(_!==T.outputColorSpace||x!==T.toneMapping){_=T.outputColorSpace,x=T.toneMapping,d.defines={},ft.getTransfer(_)===Pt&&(d.defines.SRGB_TRANSFER="");let U=u1[x];U&&(d.defines[U]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=v.texture,T.setRenderTarget(w),T.render(u,f),w=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){s.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),c.dispose(),d.dispose()}}var Sm=new br,ym=new Yn(1,1),Em=new nm(1),bm=new Xp,wm=new cv,Tm=new am,ip=[],rp=[],ap=new Float32Array(16),np=new Float32Array(9),sp=new Float32Array(4);function Jn(e,t,i){let r=e[0];if(r<=0||r>0)return e;let a=t*i,n=ip[a];if(n===void 0&&(n=new Float32Array(a),ip[a]=n),t!==0){r.toArray(n,0);for(let s=1,o=0;s!==t;++s)o+=i,e[s].toArray(n,o)}return n}function di(e,t){if(e.length!==t.length)return!1;for(let i=0,r=e.length;i<r;i++)if(e[i]!==t[i])return!1;return!0}function fi(e,t){for(let i=0,r=t.length;i<r;i++)e[i]=t[i]}function cl(e,t){let i=rp[t];i===void 0&&(i=new Int32Array(t),rp[t]=i);for(let r=0;r!==t;++r)i[r]=e.allocateTextureUnit();return i}function f1(e,t){let i=this.cache;i[0]!==t&&(e.uniform1f(this.addr,t),i[0]=t)}function p1(e,t){let i=this.cache;if(t.x!==void 0)(i[0]!==t.x||i[1]!==t.y)&&(e.uniform2f(this.addr,t.x,t.y),i[0]=t.x,i[1]=t.y);else{if(di(i,t))return;e.uniform2fv(this.addr,t),fi(i,t)}}function m1(e,t){let i=this.cache;if(t.x!==void 0)(i[0]!==t.x||i[1]!==t.y||i[2]!==t.z)&&(e.uniform3f(this.addr,t.x,t.y,t.z),i[0]=t.x,i[1]=t.y,i[2]=t.z);else if(t.r!==void 0)(i[0]!==t.r||i[1]!==t.g||i[2]!==t.b)&&(e.uniform3f(this.addr,t.r,t.g,t.b),i[0]=t.r,i[1]=t.g,i[2]=t.b);else{if(di(i,t))return;e.uniform3fv(this.addr,t),fi(i,t)}}function g1(e,t){let i=this.cache;if(t.x!==void 0)(i[0]!==t.x||i[1]!==t.y||i[2]!==t.z||i[3]!==t.w)&&(e.uniform4f(this.addr,t.x,t.y,t.z,t.w),i[0]=t.x,i[1]=t.y,i[2]=t.z,i[3]=t.w);else{if(di(i,t))return;e.uniform4fv(this.addr,t),fi(i,t)}}function _1(e,t){let i=this.cache,r=t.elements;if(r===void 0){if(di(i,t))return;e.uniformMatrix2fv(this.addr,!1,t),fi(i,t)}else{if(di(i,r))return;sp.set(r),e.uniformMatrix2fv(this.addr,!1,sp),fi(i,r)}}function v1(e,t){let i=this.cache,r=t.elements;if(r===void 0){if(di(i,t))return;e.uniformMatrix3fv(this.addr,!1,t),fi(i,t)}else{if(di(i,r))return;np.set(r),e.uniformMatrix3fv(this.addr,!1,np),fi(i,r)}}function x1(e,t){let i=this.cache,r=t.elements;if(r===void 0){if(di(i,t))return;e.uniformMatrix4fv(this.addr,!1,t),fi(i,t)}else{if(di(i,r))return;ap.set(r),e.uniformMatrix4fv(this.addr,!1,ap),fi(i,r)}}function M1(e,t){let i=this.cache;i[0]!==t&&(e.uniform1i(this.addr,t),i[0]=t)}function S1(e,t){let i=this.cache;if(t.x!==void 0)(i[0]!==t.x||i[1]!==t.y)&&(e.uniform2i(this.addr,t.x,t.y),i[0]=t.x,i[1]=t.y);else{if(di(i,t))return;e.uniform2iv(this.addr,t),fi(i,t)}}function y1(e,t){let i=this.cache;if(t.x!==void 0)(i[0]!==t.x||i[1]!==t.y||i[2]!==t.z)&&(e.uniform3i(this.addr,t.x,t.y,t.z),i[0]=t.x,i[1]=t.y,i[2]=t.z);else{if(di(i,t))return;e.uniform3iv(this.addr,t),fi(i,t)}}function E1(e,t){let i=this.cache;if(t.x!==void 0)(i[0]!==t.x||i[1]!==t.y||i[2]!==t.z||i[3]!==t.w)&&(e.uniform4i(this.addr,t.x,t.y,t.z,t.w),i[0]=t.x,i[1]=t.y,i[2]=t.z,i[3]=t.w);else{if(di(i,t))return;e.uniform4iv(this.addr,t),fi(i,t)}}function b1(e,t){let i=this.cache;i[0]!==t&&(e.uniform1ui(this.addr,t),i[0]=t)}function w1(e,t){let i=this.cache;if(t.x!==void 0)(i[0]!==t.x||i[1]!==t.y)&&(e.uniform2ui(this.addr,t.x,t.y),i[0]=t.x,i[1]=t.y);else{if(di(i,t))return;e.uniform2uiv(this.addr,t),fi(i,t)}}function T1(e,t){let i=this.cache;if(t.x!==void 0)(i[0]!==t.x||i[1]!==t.y||i[2]!==t.z)&&(e.uniform3ui(this.addr,t.x,t.y,t.z),i[0]=t.x,i[1]=t.y,i[2]=t.z);else{if(di(i,t))return;e.uniform3uiv(this.addr,t),fi(i,t)}}function A1(e,t){let i=this.cache;if(t.x!==void 0)(i[0]!==t.x||i[1]!==t.y||i[2]!==t.z||i[3]!==t.w)&&(e.uniform4ui(this.addr,t.x,t.y,t.z,t.w),i[0]=t.x,i[1]=t.y,i[2]=t.z,i[3]=t.w);else{if(di(i,t))return;e.uniform4uiv(this.addr,t),fi(i,t)}}function ul(e){return e.version===0&&(e.compareFunction=Hp,e.needsUpdate=!0),e}function R1(e,t,i){let r=this.cache,a=i.allocateTextureUnit();r[0]!==a&&(e.uniform1i(this.addr,a),r[0]=a);let n;this.type===e.SAMPLER_2D_SHADOW?n=ul(ym):n=Sm,i.setTexture2D(t||n,a)}function C1(e,t,i){let r=this.cache,a=i.allocateTextureUnit();r[0]!==a&&(e.uniform1i(this.addr,a),r[0]=a),i.setTexture3D(t||wm,a)}function P1(e,t,i){let r=this.cache,a=i.allocateTextureUnit();r[0]!==a&&(e.uniform1i(this.addr,a),r[0]=a);let n;this.type===e.SAMPLER_CUBE_SHADOW?n=ul(Em):n=Tm,i.setTextureCube(t||n,a)}function L1(e,t,i){let r=this.cache,a=i.allocateTextureUnit();r[0]!==a&&(e.uniform1i(this.addr,a),r[0]=a),i.setTexture2DArray(t||bm,a)}function D1(e){switch(e){case 5126:return f1;case 35664:return p1;case 35665:return m1;case 35666:return g1;case 35674:return _1;case 35675:return v1;case 35676:return x1;case 5124:case 35670:return M1;case 35667:case 35671:return S1;case 35668:case 35672:return y1;case 35669:case 35673:return E1;case 5125:return b1;case 36294:return w1;case 36295:return T1;case 36296:return A1;case 35678:case 36198:case 36298:case 36306:case 35682:return R1;case 35679:case 36299:case 36307:return C1;case 35680:case 36300:case 36308:case 36293:return P1;case 36289:case 36303:case 36311:case 36292:return L1}}function N1(e,t){e.uniform1fv(this.addr,t)}function I1(e,t){let i=Jn(t,this.size,2);e.uniform2fv(this.addr,i)}function U1(e,t){let i=Jn(t,this.size,3);e.uniform3fv(this.addr,i)}function O1(e,t){let i=Jn(t,this.size,4);e.uniform4fv(this.addr,i)}function F1(e,t){let i=Jn(t,this.size,4);e.uniformMatrix2fv(this.addr,!1,i)}function k1(e,t){let i=Jn(t,this.size,9);e.uniformMatrix3fv(this.addr,!1,i)}function B1(e,t){let i=Jn(t,this.size,16);e.uniformMatrix4fv(this.addr,!1,i)}function z1(e,t){e.uniform1iv(this.addr,t)}function H1(e,t){e.uniform2iv(this.addr,t)}function G1(e,t){e.uniform3iv(this.addr,t)}function V1(e,t){e.uniform4iv(this.addr,t)}function W1(e,t){e.uniform1uiv(this.addr,t)}function j1(e,t){e.uniform2uiv(this.addr,t)}function X1(e,t){e.uniform3uiv(this.addr,t)}function Y1(e,t){e.uniform4uiv(this.addr,t)}function q1(e,t,i){let r=this.cache,a=t.length,n=cl(i,a);di(r,n)||(e.uniform1iv(this.addr,n),fi(r,n));let s;this.type===e.SAMPLER_2D_SHADOW?s=ul(ym):s=Sm;for(let o=0;o!==a;++o)i.setTexture2D(t[o]||s,n[o])}function $1(e,t,i){let r=this.cache,a=t.length,n=cl(i,a);di(r,n)||(e.uniform1iv(this.addr,n),fi(r,n));for(let s=0;s!==a;++s)i.setTexture3D(t[s]||wm,n[s])}function K1(e,t,i){let r=this.cache,a=t.length,n=cl(i,a);di(r,n)||(e.uniform1iv(this.addr,n),fi(r,n));let s;this.type===e.SAMPLER_CUBE_SHADOW?s=ul(Em):s=Tm;for(let o=0;o!==a;++o)i.setTextureCube(t[o]||s,n[o])}function J1(e,t,i){let r=this.cache,a=t.length,n=cl(i,a);di(r,n)||(e.uniform1iv(this.addr,n),fi(r,n));for(let s=0;s!==a;++s)i.setTexture2DArray(t[s]||bm,n[s])}function Z1(e){switch(e){case 5126:return N1;case 35664:return I1;case 35665:return U1;case 35666:return O1;case 35674:return F1;case 35675:return k1;case 35676:return B1;case 5124:case 35670:return z1;case 35667:case 35671:return H1;case 35668:case 35672:return G1;case 35669:case 35673:return V1;case 5125:return W1;case 36294:return j1;case 36295:return X1;case 36296:return Y1;case 35678:case 36198:case 36298:case 36306:case 35682:return q1;case 35679:case 36299:case 36307:return $1;case 35680:case 36300:case 36308:case 36293:return K1;case 36289:case 36303:case 36311:case 36292:return J1}}var Q1=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=D1(t.type)}},ey=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Z1(t.type)}},ty=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let r=this.seq;for(let a=0,n=r.length;a!==n;++a){let s=r[a];s.setValue(e,t[s.id],i)}}},jh=/(\w+)(\])?(\[|\.)?/g;function op(e,t){e.seq.push(t),e.map[t.id]=t}function iy(e,t,i){let r=e.name,a=r.length;for(jh.lastIndex=0;;){let n=jh.exec(r),s=jh.lastIndex,o=n[1],l=n[2]==="]",h=n[3];if(l&&(o=o|0),h===void 0||h==="["&&s+2===a){op(i,h===void 0?new Q1(o,e,t):new ey(o,e,t));break}else{let c=i.map[o];c===void 0&&(c=new ty(o),op(i,c)),i=c}}}var Zo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let n=0;n<i;++n){let s=e.getActiveUniform(t,n),o=e.getUniformLocation(t,s.name);iy(s,o,this)}let r=[],a=[];for(let n of this.seq)n.type===e.SAMPLER_2D_SHADOW||n.type===e.SAMPLER_CUBE_SHADOW||n.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(n):a.push(n);r.length>0&&(this.seq=r.concat(a))}setValue(e,t,i,r){let a=this.map[t];a!==void 0&&a.setValue(e,i,r)}setOptional(e,t,i){let r=t[i];r!==void 0&&this.setValue(e,i,r)}static upload(e,t,i,r){for(let a=0,n=t.length;a!==n;++a){let s=t[a],o=i[s.id];o.needsUpdate!==!1&&s.setValue(e,o.value,r)}}static seqWithValue(e,t){let i=[];for(let r=0,a=e.length;r!==a;++r){let n=e[r];n.id in t&&i.push(n)}return i}};function lp(e,t,i){let r=e.createShader(t);return e.shaderSource(r,i),e.compileShader(r),r}var ry=37297,ay=0;function ny(e,t){let i=e.split(`
`),r=[],a=Math.max(t-6,0),n=Math.min(t+6,i.length);for(let s=a;s<n;s++){let o=s+1;r.push(`${o===t?">":" "} ${o}: ${i[s]}`)}return r.join(`
`)}var hp=new et;function sy(e){ft._getMatrix(hp,ft.workingColorSpace,e);let t=`mat3( ${hp.elements.map(i=>i.toFixed(4))} )`;switch(ft.getTransfer(e)){case rl:return[t,"LinearTransferOETF"];case Pt:return[t,"sRGBTransferOETF"];default:return Ye("WebGLProgram: Unsupported color space: ",e),[t,"LinearTransferOETF"]}}function cp(e,t,i){let r=e.getShaderParameter(t,e.COMPILE_STATUS),a=(e.getShaderInfoLog(t)||"").trim();if(r&&a==="")return"";let n=/ERROR: 0:(\d+)/.exec(a);if(n){let s=parseInt(n[1]);return i.toUpperCase()+`

`+a+`

`+ny(e.getShaderSource(t),s)}else return a}function oy(e,t){let i=sy(t);return[`vec4 ${e}( vec4 value ) {`,`	return ${i[1]}( vec4( ${i[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var ly={[bp]:"Linear",[wp]:"Reinhard",[Tp]:"Cineon",[Ap]:"ACESFilmic",[Cp]:"AgX",[Pp]:"Neutral",[Rp]:"Custom"};function hy(e,t){let i=ly[t];return i===void 0?(Ye("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+e+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+e+"( vec3 color ) { return "+i+"ToneMapping( color ); }"}var Go=new X;function cy(){ft.getLuminanceCoefficients(Go);let e=Go.x.toFixed(4),t=Go.y.toFixed(4),i=Go.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${e}, ${t}, ${i} );`,"	return dot( weights, rgb );","}"].join(`
`)}function uy(e){return[e.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",e.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(As).join(`
`)}function dy(e){let t=[];for(let i in e){let r=e[i];r!==!1&&t.push("#define "+i+" "+r)}return t.join(`
`)}function fy(e,t){let i={},r=e.getProgramParameter(t,e.ACTIVE_ATTRIBUTES);for(let a=0;a<r;a++){let n=e.getActiveAttrib(t,a),s=n.name,o=1;n.type===e.FLOAT_MAT2&&(o=2),n.type===e.FLOAT_MAT3&&(o=3),n.type===e.FLOAT_MAT4&&(o=4),i[s]={type:n.type,location:e.getAttribLocation(t,s),locationSize:o}}return i}function As(e){return e!==""}function up(e,t){let i=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return e.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,i).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function dp(e,t){return e.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var py=/^[ \t]*#include +<([\w\d./]+)>/gm;function Oc(e){return e.replace(py,my)}function my(e,t){let i=it[t];if(i===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Oc(i)}var gy=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function fp(e){return e.replace(gy,_y)}function _y(e,t,i,r){let a="";for(let n=parseInt(t);n<parseInt(i);n++)a+=r.replace(/\[\s*i\s*\]/g,"[ "+n+" ]").replace(/UNROLLED_LOOP_INDEX/g,n);return a}function pp(e){let t=`precision ${e.precision} float;
	precision ${e.precision} int;
	precision ${e.precision} sampler2D;
	precision ${e.precision} samplerCube;
	precision ${e.precision} sampler3D;
	precision ${e.precision} sampler2DArray;
	precision ${e.precision} sampler2DShadow;
	precision ${e.precision} samplerCubeShadow;
	precision ${e.precision} sampler2DArrayShadow;
	precision ${e.precision} isampler2D;
	precision ${e.precision} isampler3D;
	precision ${e.precision} isamplerCube;
	precision ${e.precision} isampler2DArray;
	precision ${e.precision} usampler2D;
	precision ${e.precision} usampler3D;
	precision ${e.precision} usamplerCube;
	precision ${e.precision} usampler2DArray;
	`;return e.precision==="highp"?t+=`
#define HIGH_PRECISION`:e.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:e.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var vy={[Wo]:"SHADOWMAP_TYPE_PCF",[Ts]:"SHADOWMAP_TYPE_VSM"};function xy(e){return vy[e.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var My={[Ds]:"ENVMAP_MODE_REFRACTION"};function Sy(e){return e.envMap===!1?"ENVMAP_MODE_REFLECTION":My[e.envMapMode]||"ENVMAP_MODE_REFLECTION"}var yy={[Ep]:"ENVMAP_BLENDING_MULTIPLY",[T_]:"ENVMAP_BLENDING_MIX",[A_]:"ENVMAP_BLENDING_ADD"};function Ey(e){return e.envMap===!1?"ENVMAP_BLENDING_NONE":yy[e.combine]||"ENVMAP_BLENDING_NONE"}function by(e,t,i,r){let a=e.getContext(),n=i.defines,s=i.vertexShader,o=i.fragmentShader,l=xy(i),h=i.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",c=Sy(i),d=Ey(i),u=uy(i),f=dy(n),_=a.createProgram(),x,p,m=i.glslVersion?"#version "+i.glslVersion+`
`:"";i.isRawShaderMaterial?(x=["#define SHADER_TYPE "+i.shaderType,"#define SHADER_NAME "+i.shaderName,f].filter(As).join(`
`),x.length>0&&(x+=`
`),p=["#define SHADER_TYPE "+i.shaderType,"#define SHADER_NAME "+i.shaderName,f].filter(As).join(`
`),p.length>0&&(p+=`
`)):(x=[pp(i),"#define SHADER_TYPE "+i.shaderType,"#define SHADER_NAME "+i.shaderName,f,i.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",i.batching?"#define USE_BATCHING":"",i.batchingColor?"#define USE_BATCHING_COLOR":"",i.instancing?"#define USE_INSTANCING":"",i.instancingColor?"#define USE_INSTANCING_COLOR":"",i.instancingMorph?"#define USE_INSTANCING_MORPH":"",i.useFog&&i.fog?"#define USE_FOG":"",i.useFog&&i.fogExp2?"#define FOG_EXP2":"",i.map?"#define USE_MAP":"",i.envMap?"#define USE_ENVMAP":"",i.envMap?"#define "+c:"",i.lightMap?"#define USE_LIGHTMAP":"",i.aoMap?"#define USE_AOMAP":"",i.bumpMap?"#define USE_BUMPMAP":"",i.normalMap?"#define USE_NORMALMAP":"",i.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",i.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",i.displacementMap?"#define USE_DISPLACEMENTMAP":"",i.emissiveMap?"#define USE_EMISSIVEMAP":"",i.anisotropy?"#define USE_ANISOTROPY":"",i.anisotropyMap?"#define USE_ANISOTROPYMAP":"",i.clearcoatMap?"#define USE_CLEARCOATMAP":"",i.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",i.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",i.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",i.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",i.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",i.specularMap?"#define USE_SPECULARMAP":"",i.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",i.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",i.roughnessMap?"#define USE_ROUGHNESSMAP":"",i.metalnessMap?"#define USE_METALNESSMAP":"",i.alphaMap?"#define USE_ALPHAMAP":"",i.alphaHash?"#define USE_ALPHAHASH":"",i.transmission?"#define USE_TRANSMISSION":"",i.transmissionMap?"#define USE_TRANSMISSIONMAP":"",i.thicknessMap?"#define USE_THICKNESSMAP":"",i.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",i.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",i.mapUv?"#define MAP_UV "+i.mapUv:"",i.alphaMapUv?"#define ALPHAMAP_UV "+i.alphaMapUv:"",i.lightMapUv?"#define LIGHTMAP_UV "+i.lightMapUv:"",i.aoMapUv?"#define AOMAP_UV "+i.aoMapUv:"",i.emissiveMapUv?"#define EMISSIVEMAP_UV "+i.emissiveMapUv:"",i.bumpMapUv?"#define BUMPMAP_UV "+i.bumpMapUv:"",i.normalMapUv?"#define NORMALMAP_UV "+i.normalMapUv:"",i.displacementMapUv?"#define DISPLACEMENTMAP_UV "+i.displacementMapUv:"",i.metalnessMapUv?"#define METALNESSMAP_UV "+i.metalnessMapUv:"",i.roughnessMapUv?"#define ROUGHNESSMAP_UV "+i.roughnessMapUv:"",i.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+i.anisotropyMapUv:"",i.clearcoatMapUv?"#define CLEARCOATMAP_UV "+i.clearcoatMapUv:"",i.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+i.clearcoatNormalMapUv:"",i.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+i.clearcoatRoughnessMapUv:"",i.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+i.diffuseRoughnessMapUv:"",i.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+i.iridescenceMapUv:"",i.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+i.iridescenceThicknessMapUv:"",i.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+i.sheenColorMapUv:"",i.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+i.sheenRoughnessMapUv:"",i.specularMapUv?"#define SPECULARMAP_UV "+i.specularMapUv:"",i.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+i.specularColorMapUv:"",i.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+i.specularIntensityMapUv:"",i.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+i.transmissionMapUv:"",i.thicknessMapUv?"#define THICKNESSMAP_UV "+i.thicknessMapUv:"",i.vertexTangents&&i.flatShading===!1?"#define USE_TANGENT":"",i.vertexNormals?"#define HAS_NORMAL":"",i.vertexColors?"#define USE_COLOR":"",i.vertexAlphas?"#define USE_COLOR_ALPHA":"",i.vertexUv1s?"#define USE_UV1":"",i.vertexUv2s?"#define USE_UV2":"",i.vertexUv3s?"#define USE_UV3":"",i.pointsUvs?"#define USE_POINTS_UV":"",i.flatShading?"#define FLAT_SHADED":"",i.skinning?"#define USE_SKINNING":"",i.morphTargets?"#define USE_MORPHTARGETS":"",i.morphNormals&&i.flatShading===!1?"#define USE_MORPHNORMALS":"",i.morphColors?"#define USE_MORPHCOLORS":"",i.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+i.morphTextureStride:"",i.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+i.morphTargetsCount:"",i.doubleSided?"#define DOUBLE_SIDED":"",i.flipSided?"#define FLIP_SIDED":"",i.shadowMapEnabled?"#define USE_SHADOWMAP":"",i.shadowMapEnabled?"#define "+l:"",i.sizeAttenuation?"#define USE_SIZEATTENUATION":"",i.numLightProbes>0?"#define USE_LIGHT_PROBES":"",i.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",i.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(As).join(`
`),p=[pp(i),"#define SHADER_TYPE "+i.shaderType,"#define SHADER_NAME "+i.shaderName,f,i.useFog&&i.fog?"#define USE_FOG":"",i.useFog&&i.fogExp2?"#define FOG_EXP2":"",i.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",i.map?"#define USE_MAP":"",i.matcap?"#define USE_MATCAP":"",i.envMap?"#define USE_ENVMAP":"",i.envMap?"#define "+h:"",i.envMap?"#define "+c:"",i.envMap?"#define "+d:"",i.envMapPMREM?"#define ENVMAP_MAX_LOD "+i.envMapMaxLod+".0":"",i.envMapPMREM?"#define ENVMAP_SIZE "+i.envMapSize+".0":"",i.lightMap?"#define USE_LIGHTMAP":"",i.aoMap?"#define USE_AOMAP":"",i.bumpMap?"#define USE_BUMPMAP":"",i.normalMap?"#define USE_NORMALMAP":"",i.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",i.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",i.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",i.emissiveMap?"#define USE_EMISSIVEMAP":"",i.anisotropy?"#define USE_ANISOTROPY":"",i.anisotropyMap?"#define USE_ANISOTROPYMAP":"",i.clearcoat?"#define USE_CLEARCOAT":"",i.clearcoatMap?"#define USE_CLEARCOATMAP":"",i.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",i.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",i.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",i.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",i.dispersion?"#define USE_DISPERSION":"",i.retroreflection?"#define USE_RETROREFLECTION":"",i.iridescence?"#define USE_IRIDESCENCE":"",i.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",i.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",i.specularMap?"#define USE_SPECULARMAP":"",i.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",i.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",i.roughnessMap?"#define USE_ROUGHNESSMAP":"",i.metalnessMap?"#define USE_METALNESSMAP":"",i.alphaMap?"#define USE_ALPHAMAP":"",i.alphaTest?"#define USE_ALPHATEST":"",i.alphaHash?"#define USE_ALPHAHASH":"",i.sheen?"#define USE_SHEEN":"",i.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",i.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",i.transmission?"#define USE_TRANSMISSION":"",i.transmissionMap?"#define USE_TRANSMISSIONMAP":"",i.thicknessMap?"#define USE_THICKNESSMAP":"",i.vertexTangents&&i.flatShading===!1?"#define USE_TANGENT":"",i.vertexColors||i.instancingColor?"#define USE_COLOR":"",i.vertexAlphas||i.batchingColor?"#define USE_COLOR_ALPHA":"",i.vertexUv1s?"#define USE_UV1":"",i.vertexUv2s?"#define USE_UV2":"",i.vertexUv3s?"#define USE_UV3":"",i.pointsUvs?"#define USE_POINTS_UV":"",i.gradientMap?"#define USE_GRADIENTMAP":"",i.flatShading?"#define FLAT_SHADED":"",i.doubleSided?"#define DOUBLE_SIDED":"",i.flipSided?"#define FLIP_SIDED":"",i.shadowMapEnabled?"#define USE_SHADOWMAP":"",i.shadowMapEnabled?"#define "+l:"",i.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",i.numLightProbes>0?"#define USE_LIGHT_PROBES":"",i.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",i.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",i.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",i.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",i.toneMapping!==na?"#define TONE_MAPPING":"",i.toneMapping!==na?it.tonemapping_pars_fragment:"",i.toneMapping!==na?hy("toneMapping",i.toneMapping):"",i.dithering?"#define DITHERING":"",i.opaque?"#define OPAQUE":"",it.colorspace_pars_fragment,oy("linearToOutputTexel",i.outputColorSpace),cy(),i.useDepthPacking?"#define DEPTH_PACKING "+i.depthPacking:"",`
`].filter(As).join(`
`)),s=Oc(s),s=up(s,i),s=dp(s,i),o=Oc(o),o=up(o,i),o=dp(o,i),s=fp(s),o=fp(o),i.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,x=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,p=["#define varying in",i.glslVersion===xf?"":"layout(location = 0) out highp vec4 pc_fragColor;",i.glslVersion===xf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let w=m+x+s,R=m+p+o,E=lp(a,a.VERTEX_SHADER,w),T=lp(a,a.FRAGMENT_SHADER,R);a.attachShader(_,E),a.attachShader(_,T),i.index0AttributeName!==void 0?a.bindAttribLocation(_,0,i.index0AttributeName):i.hasPositionAttribute===!0&&a.bindAttribLocation(_,0,"position"),a.linkProgram(_);function P(W){if(e.debug.checkShaderErrors){let N=a.getProgramInfoLog(_)||"",B=a.getShaderInfoLog(E)||"",I=a.getShaderInfoLog(T)||"",L=N.trim(),G=B.trim(),Z=I.trim(),O=!0,de=!0;if(a.getProgramParameter(_,a.LINK_STATUS)===!1)if(O=!1,typeof e.debug.onShaderError=="function")e.debug.onShaderError(a,_,E,T);else{let J=cp(a,E,"vertex"),te=cp(a,T,"fragment");Ze("WebGLProgram: Shader Error "+a.getError()+" - VALIDATE_STATUS "+a.getProgramParameter(_,a.VALIDATE_STATUS)+`

Material Name: `+W.name+`
Material Type: `+W.type+`

Program Info Log: `+L+`
`+J+`
`+te)}else L!==""?Ye("WebGLProgram: Program Info Log:",L):(G===""||Z==="")&&(de=!1);de&&(W.diagnostics={runnable:O,programLog:L,vertexShader:{log:G,prefix:x},fragmentShader:{log:Z,prefix:p}})}a.deleteShader(E),a.deleteShader(T),v=new Zo(a,_),b=fy(a,_)}let v;this.getUniforms=function(){return v===void 0&&P(this),v};let b;this.getAttributes=function(){return b===void 0&&P(this),b};let U=i.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=a.getProgramParameter(_,ry)),U},this.destroy=function(){r.releaseStatesOfProgram(this),a.deleteProgram(_),this.program=void 0},this.type=i.shaderType,this.name=i.shaderName,this.id=ay++,this.cacheKey=t,this.usedTimes=1,this.program=_,this.vertexShader=E,this.fragmentShader=T,this}var wy=0,Ty=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(i)===!1&&(r.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Ay(e),t.set(e,i)),i}},Ay=class{constructor(e){this.id=wy++,this.code=e,this.usedTimes=0}};function Ry(e){return e===Ja||e===Qo||e===el}function Cy(e,t,i,r,a,n){let s=new $p,o=new Ty,l=new Set,h=[],c=new Map,d=r.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(v){return l.add(v),v===0?"uv":`uv${v}`}function _(v,b,U,W,N,B){let I=W.fog,L=N.geometry,G=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?W.environment:null,Z=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,O=t.get(v.envMap||G,Z),de=u[v.type],J=r.precision;v.precision!==null&&(J=r.getMaxPrecision(v.precision),J!==v.precision&&Ye("WebGLProgram.getParameters:",v.precision,"not supported, using",J,"instead."));let te=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,ne=te!==void 0?te.length:0,Le=0;L.morphAttributes.position!==void 0&&(Le=1),L.morphAttributes.normal!==void 0&&(Le=2),L.morphAttributes.color!==void 0&&(Le=3);let K,re,se,Ce;if(de){let Ae=kr[de];K=Ae.vertexShader,re=Ae.fragmentShader}else{K=v.vertexShader,re=v.fragmentShader;let Ae=o.getVertexShaderStage(v),yt=o.getFragmentShaderStage(v);o.update(v,Ae,yt),se=Ae.id,Ce=yt.id}let Re=e.getRenderTarget(),le=e.state.buffers.depth.getReversed(),Fe=N.isInstancedMesh===!0,We=N.isBatchedMesh===!0,we=!!v.map,at=!!v.matcap,_t=!!O,Mt=_t&&O.isPMREMTexture===!0,$e=!!v.aoMap,St=!!v.lightMap,Nt=!!v.bumpMap&&v.wireframe===!1,vt=!!v.normalMap,Zt=!!v.displacementMap,mi=!!v.emissiveMap,Ut=!!v.metalnessMap,kt=!!v.roughnessMap,V=v.anisotropy>0,oi=v.clearcoat>0,ht=v.diffuseRoughness>0,ve=v.dispersion>0,ae=v.retroreflectivity>0,Ke=v.iridescence>0,Oe=v.sheen>0,je=v.transmission>0,Ot=V&&!!v.anisotropyMap,A=oi&&!!v.clearcoatMap,M=oi&&!!v.clearcoatNormalMap,j=oi&&!!v.clearcoatRoughnessMap,he=ht&&!!v.diffuseRoughnessMap,ie=Ke&&!!v.iridescenceMap,xe=Ke&&!!v.iridescenceThicknessMap,Me=Oe&&!!v.sheenColorMap,z=Oe&&!!v.sheenRoughnessMap,ce=!!v.specularMap,ye=!!v.specularColorMap,F=!!v.specularIntensityMap,Q=je&&!!v.transmissionMap,ue=je&&!!v.thicknessMap,me=!!v.gradientMap,Te=!!v.alphaMap,Ee=v.alphaTest>0,Ve=!!v.alphaHash,fe=!!v.extensions,Je=na;v.toneMapped&&(Re===null||Re.isXRRenderTarget===!0)&&(Je=e.toneMapping);let He=Mt?O.isCompressedCubeTexture?O.image[0].mipmaps:O.mipmaps:null,Xe={shaderID:de,shaderType:v.type,shaderName:v.name,vertexShader:K,fragmentShader:re,defines:v.defines,customVertexShaderID:se,customFragmentShaderID:Ce,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:J,batching:We,batchingColor:We&&N._colorsTexture!==null,instancing:Fe,instancingColor:Fe&&N.instanceColor!==null,instancingMorph:Fe&&N.morphTexture!==null,outputColorSpace:Re===null?e.outputColorSpace:Re.isXRRenderTarget===!0?Re.texture.colorSpace:ft.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:we,matcap:at,envMap:_t,envMapMode:_t&&O.mapping,envMapPMREM:Mt,envMapMaxLod:Mt?He.length-1:null,envMapSize:Mt?He[0].width:null,aoMap:$e,lightMap:St,bumpMap:Nt,normalMap:vt,displacementMap:Zt,emissiveMap:mi,normalMapObjectSpace:vt&&v.normalMapType===P_,normalMapTangentSpace:vt&&v.normalMapType===vf,packedNormalMap:vt&&v.normalMapType===vf&&Ry(v.normalMap.format),metalnessMap:Ut,roughnessMap:kt,anisotropy:V,anisotropyMap:Ot,clearcoat:oi,clearcoatMap:A,clearcoatNormalMap:M,clearcoatRoughnessMap:j,diffuseRoughness:ht,diffuseRoughnessMap:he,dispersion:ve,retroreflection:ae,iridescence:Ke,iridescenceMap:ie,iridescenceThicknessMap:xe,sheen:Oe,sheenColorMap:Me,sheenRoughnessMap:z,specularMap:ce,specularColorMap:ye,specularIntensityMap:F,transmission:je,transmissionMap:Q,thicknessMap:ue,gradientMap:me,opaque:v.transparent===!1&&v.blending===Rs&&v.alphaToCoverage===!1,alphaMap:Te,alphaTest:Ee,alphaHash:Ve,combine:v.combine,mapUv:we&&f(v.map.channel),aoMapUv:$e&&f(v.aoMap.channel),lightMapUv:St&&f(v.lightMap.channel),bumpMapUv:Nt&&f(v.bumpMap.channel),normalMapUv:vt&&f(v.normalMap.channel),displacementMapUv:Zt&&f(v.displacementMap.channel),emissiveMapUv:mi&&f(v.emissiveMap.channel),metalnessMapUv:Ut&&f(v.metalnessMap.channel),roughnessMapUv:kt&&f(v.roughnessMap.channel),anisotropyMapUv:Ot&&f(v.anisotropyMap.channel),clearcoatMapUv:A&&f(v.clearcoatMap.channel),clearcoatNormalMapUv:M&&f(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:j&&f(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&f(v.diffuseRoughnessMap.channel),iridescenceMapUv:ie&&f(v.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&f(v.iridescenceThicknessMap.channel),sheenColorMapUv:Me&&f(v.sheenColorMap.channel),sheenRoughnessMapUv:z&&f(v.sheenRoughnessMap.channel),specularMapUv:ce&&f(v.specularMap.channel),specularColorMapUv:ye&&f(v.specularColorMap.channel),specularIntensityMapUv:F&&f(v.specularIntensityMap.channel),transmissionMapUv:Q&&f(v.transmissionMap.channel),thicknessMapUv:ue&&f(v.thicknessMap.channel),alphaMapUv:Te&&f(v.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(vt||V),vertexNormals:!!L.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!L.attributes.uv&&(we||Te),fog:!!I,useFog:v.fog===!0,fogExp2:!!I&&I.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||L.attributes.normal===void 0&&vt===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:le,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:L.attributes.position!==void 0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:ne,morphTextureStride:Le,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:B.filter(Ae=>Ae.texture!==null).length,numClippingPlanes:n.numPlanes,numClipIntersection:n.numIntersection,dithering:v.dithering,shadowMapEnabled:e.shadowMap.enabled&&U.length>0,shadowMapType:e.shadowMap.type,toneMapping:Je,decodeVideoTexture:we&&v.map.isVideoTexture===!0&&ft.getTransfer(v.map.colorSpace)===Pt,decodeVideoTextureEmissive:mi&&v.emissiveMap.isVideoTexture===!0&&ft.getTransfer(v.emissiveMap.colorSpace)===Pt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===ra,flipSided:v.side===Vi,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:fe&&v.extensions.clipCullDistance===!0&&i.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(fe&&v.extensions.multiDraw===!0||We)&&i.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:i.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return Xe.vertexUv1s=l.has(1),Xe.vertexUv2s=l.has(2),Xe.vertexUv3s=l.has(3),l.clear(),Xe}function x(v){let b=[];if(v.shaderID?b.push(v.shaderID):(b.push(v.customVertexShaderID),b.push(v.customFragmentShaderID)),v.defines!==void 0)for(let U in v.defines)b.push(U),b.push(v.defines[U]);return v.isRawShaderMaterial===!1&&(p(b,v),m(b,v),b.push(e.outputColorSpace)),b.push(v.customProgramCacheKey),b.join()}function p(v,b){v.push(b.precision),v.push(b.outputColorSpace),v.push(b.envMapMode),v.push(b.envMapPMREM),v.push(b.envMapMaxLod),v.push(b.envMapSize),v.push(b.mapUv),v.push(b.alphaMapUv),v.push(b.lightMapUv),v.push(b.aoMapUv),v.push(b.bumpMapUv),v.push(b.normalMapUv),v.push(b.displacementMapUv),v.push(b.emissiveMapUv),v.push(b.metalnessMapUv),v.push(b.roughnessMapUv),v.push(b.anisotropyMapUv),v.push(b.clearcoatMapUv),v.push(b.clearcoatNormalMapUv),v.push(b.clearcoatRoughnessMapUv),v.push(b.diffuseRoughnessMapUv),v.push(b.iridescenceMapUv),v.push(b.iridescenceThicknessMapUv),v.push(b.sheenColorMapUv),v.push(b.sheenRoughnessMapUv),v.push(b.specularMapUv),v.push(b.specularColorMapUv),v.push(b.specularIntensityMapUv),v.push(b.transmissionMapUv),v.push(b.thicknessMapUv),v.push(b.combine),v.push(b.fogExp2),v.push(b.sizeAttenuation),v.push(b.morphTargetsCount),v.push(b.numSunLights),v.push(b.numDirLights),v.push(b.numPointLights),v.push(b.numSpotLights),v.push(b.numSpotLightMaps),v.push(b.numHemiLights),v.push(b.numRectAreaLights),v.push(b.numSunLightShadows),v.push(b.numDirLightShadows),v.push(b.numPointLightShadows),v.push(b.numSpotLightShadows),v.push(b.numSpotLightShadowsWithMaps),v.push(b.numLightProbes),v.push(b.numLightProbeGrids),v.push(b.shadowMapType),v.push(b.toneMapping),v.push(b.numClippingPlanes),v.push(b.numClipIntersection),v.push(b.depthPacking)}function m(v,b){s.disableAll(),b.instancing&&s.enable(0),b.instancingColor&&s.enable(1),b.instancingMorph&&s.enable(2),b.matcap&&s.enable(3),b.envMap&&s.enable(4),b.normalMapObjectSpace&&s.enable(5),b.normalMapTangentSpace&&s.enable(6),b.clearcoat&&s.enable(7),b.iridescence&&s.enable(8),b.alphaTest&&s.enable(9),b.vertexColors&&s.enable(10),b.vertexAlphas&&s.enable(11),b.vertexUv1s&&s.enable(12),b.vertexUv2s&&s.enable(13),b.vertexUv3s&&s.enable(14),b.vertexTangents&&s.enable(15),b.anisotropy&&s.enable(16),b.alphaHash&&s.enable(17),b.batching&&s.enable(18),b.dispersion&&s.enable(19),b.retroreflection&&s.enable(24),b.diffuseRoughness&&s.enable(25),b.batchingColor&&s.enable(20),b.gradientMap&&s.enable(21),b.packedNormalMap&&s.enable(22),b.vertexNormals&&s.enable(23),v.push(s.mask),s.disableAll(),b.fog&&s.enable(0),b.useFog&&s.enable(1),b.flatShading&&s.enable(2),b.logarithmicDepthBuffer&&s.enable(3),b.reversedDepthBuffer&&s.enable(4),b.skinning&&s.enable(5),b.morphTargets&&s.enable(6),b.morphNormals&&s.enable(7),b.morphColors&&s.enable(8),b.premultipliedAlpha&&s.enable(9),b.shadowMapEnabled&&s.enable(10),b.doubleSided&&s.enable(11),b.flipSided&&s.enable(12),b.useDepthPacking&&s.enable(13),b.dithering&&s.enable(14),b.transmission&&s.enable(15),b.sheen&&s.enable(16),b.opaque&&s.enable(17),b.pointsUvs&&s.enable(18),b.decodeVideoTexture&&s.enable(19),b.decodeVideoTextureEmissive&&s.enable(20),b.alphaToCoverage&&s.enable(21),b.numLightProbeGrids>0&&s.enable(22),b.hasPositionAttribute&&s.enable(23),v.push(s.mask)}function w(v){let b=u[v.type],U;if(b){let W=kr[b];U=Lv.clone(W.uniforms)}else U=v.uniforms;return U}function R(v,b){let U=c.get(b);return U!==void 0?++U.usedTimes:(U=new by(e,b,v,a),h.push(U),c.set(b,U)),U}function E(v){if(--v.usedTimes===0){let b=h.indexOf(v);h[b]=h[h.length-1],h.pop(),c.delete(v.cacheKey),v.destroy()}}function T(v){o.remove(v)}function P(){o.dispose()}return{getParameters:_,getProgramCacheKey:x,getUniforms:w,acquireProgram:R,releaseProgram:E,releaseShaderCache:T,programs:h,dispose:P}}function Py(){let e=new WeakMap;function t(s){return e.has(s)}function i(s){let o=e.get(s);return o===void 0&&(o={},e.set(s,o)),o}function r(s){e.delete(s)}function a(s,o,l){e.get(s)[o]=l}function n(){e=new WeakMap}return{has:t,get:i,remove:r,update:a,dispose:n}}function Ly(e,t){return e.groupOrder!==t.groupOrder?e.groupOrder-t.groupOrder:e.renderOrder!==t.renderOrder?e.renderOrder-t.renderOrder:e.material.id!==t.material.id?e.material.id-t.material.id:e.materialVariant!==t.materialVariant?e.materialVariant-t.materialVariant:e.z!==t.z?e.z-t.z:e.id-t.id}function mp(e,t){return e.groupOrder!==t.groupOrder?e.groupOrder-t.groupOrder:e.renderOrder!==t.renderOrder?e.renderOrder-t.renderOrder:e.z!==t.z?t.z-e.z:e.id-t.id}function gp(){let e=[],t=0,i=[],r=[],a=[];function n(){t=0,i.length=0,r.length=0,a.length=0}function s(u){let f=0;return u.isInstancedMesh&&(f+=2),u.isSkinnedMesh&&(f+=1),f}function o(u,f,_,x,p,m){let w=e[t];return w===void 0?(w={id:u.id,object:u,geometry:f,material:_,materialVariant:s(u),groupOrder:x,renderOrder:u.renderOrder,z:p,group:m},e[t]=w):(w.id=u.id,w.object=u,w.geometry=f,w.material=_,w.materialVariant=s(u),w.groupOrder=x,w.renderOrder=u.renderOrder,w.z=p,w.group=m),t++,w}function l(u,f,_,x,p,m,w){w.reversedDepth===!0&&(p=-p);let R=o(u,f,_,x,p,m);_.transmission>0?r.push(R):_.transparent===!0?a.push(R):i.push(R)}function h(u,f,_,x,p,m){let w=o(u,f,_,x,p,m);_.transmission>0?r.unshift(w):_.transparent===!0?a.unshift(w):i.unshift(w)}function c(u,f){i.length>1&&i.sort(u||Ly),r.length>1&&r.sort(f||mp),a.length>1&&a.sort(f||mp)}function d(){for(let u=t,f=e.length;u<f;u++){let _=e[u];if(_.id===null)break;_.id=null,_.object=null,_.geometry=null,_.material=null,_.group=null}}return{opaque:i,transmissive:r,transparent:a,init:n,push:l,unshift:h,finish:d,sort:c}}function Dy(){let e=new WeakMap;function t(r,a){let n=e.get(r),s;return n===void 0?(s=new gp,e.set(r,[s])):a>=n.length?(s=new gp,n.push(s)):s=n[a],s}function i(){e=new WeakMap}return{get:t,dispose:i}}function Ny(){let e={};return{get:function(t){if(e[t.id]!==void 0)return e[t.id];let i;switch(t.type){case"SunLight":case"DirectionalLight":i={direction:new X,color:new lt};break;case"SpotLight":i={position:new X,direction:new X,color:new lt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":i={position:new X,color:new lt,distance:0,decay:0};break;case"HemisphereLight":i={direction:new X,skyColor:new lt,groundColor:new lt};break;case"RectAreaLight":i={color:new lt,position:new X,halfWidth:new X,halfHeight:new X};break}return e[t.id]=i,i}}}function Iy(){let e={};return{get:function(t){if(e[t.id]!==void 0)return e[t.id];let i;switch(t.type){case"SunLight":case"DirectionalLight":i={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new rt};break;case"SpotLight":i={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new rt};break;case"PointLight":i={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new rt,shadowCameraNear:1,shadowCameraFar:1e3};break}return e[t.id]=i,i}}}var Uy=0;function Oy(e,t){return(t.castShadow?2:0)-(e.castShadow?2:0)+(t.map?1:0)-(e.map?1:0)}function Fy(e){let t=new Ny,i=Iy(),r={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let h=0;h<9;h++)r.probe.push(new X);let a=new X,n=new ti,s=new ti;function o(h){let c=0,d=0,u=0;for(let B=0;B<9;B++)r.probe[B].set(0,0,0);let f=0,_=0,x=0,p=0,m=0,w=0,R=0,E=0,T=0,P=0,v=0,b=0,U=0,W=0;h.sort(Oy);for(let B=0,I=h.length;B<I;B++){let L=h[B],G=L.color,Z=L.intensity,O=L.distance,de=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===Ja?de=L.shadow.map.texture:de=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)c+=G.r*Z,d+=G.g*Z,u+=G.b*Z;else if(L.isLightProbe){for(let J=0;J<9;J++)r.probe[J].addScaledVector(L.sh.coefficients[J],Z);W++}else if(L.isSunLight){let J=t.get(L);if(J.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let te=L.shadow,ne=i.get(L);ne.shadowIntensity=te.intensity,ne.shadowBias=te.bias,ne.shadowNormalBias=te.normalBias,ne.shadowRadius=te.radius,ne.shadowMapSize.copy(te.mapSize).multiply(te.getFrameExtents()),r.sunShadow[_]=ne,r.sunShadowMap[_]=de;let Le=te.getViewportCount();for(let K=0;K<Le;K++)r.sunShadowMatrix[x+K]=te.getMatrix(K),r.sunShadowCascade[x+K]=te._cascadeData[K];x+=Le,_++}r.sun[f]=J,f++}else if(L.isDirectionalLight){let J=t.get(L);if(J.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let te=L.shadow,ne=i.get(L);ne.shadowIntensity=te.intensity,ne.shadowBias=te.bias,ne.shadowNormalBias=te.normalBias,ne.shadowRadius=te.radius,ne.shadowMapSize=te.mapSize,r.directionalShadow[p]=ne,r.directionalShadowMap[p]=de,r.directionalShadowMatrix[p]=L.shadow.matrix,T++}r.directional[p]=J,p++}else if(L.isSpotLight){let J=t.get(L);J.position.setFromMatrixPosition(L.matrixWorld),J.color.copy(G).multiplyScalar(Z),J.distance=O,J.coneCos=Math.cos(L.angle),J.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),J.decay=L.decay,r.spot[w]=J;let te=L.shadow;if(L.map&&(r.spotLightMap[b]=L.map,b++,te.updateMatrices(L),L.castShadow&&U++),r.spotLightMatrix[w]=te.matrix,L.castShadow){let ne=i.get(L);ne.shadowIntensity=te.intensity,ne.shadowBias=te.bias,ne.shadowNormalBias=te.normalBias,ne.shadowRadius=te.radius,ne.shadowMapSize=te.mapSize,r.spotShadow[w]=ne,r.spotShadowMap[w]=de,v++}w++}else if(L.isRectAreaLight){let J=t.get(L);J.color.copy(G).multiplyScalar(Z),J.halfWidth.set(L.width*.5,0,0),J.halfHeight.set(0,L.height*.5,0),r.rectArea[R]=J,R++}else if(L.isPointLight){let J=t.get(L);if(J.color.copy(L.color).multiplyScalar(L.intensity),J.distance=L.distance,J.decay=L.decay,L.castShadow){let te=L.shadow,ne=i.get(L);ne.shadowIntensity=te.intensity,ne.shadowBias=te.bias,ne.shadowNormalBias=te.normalBias,ne.shadowRadius=te.radius,ne.shadowMapSize=te.mapSize,ne.shadowCameraNear=te.camera.near,ne.shadowCameraFar=te.camera.far,r.pointShadow[m]=ne,r.pointShadowMap[m]=de,r.pointShadowMatrix[m]=L.shadow.matrix,P++}r.point[m]=J,m++}else if(L.isHemisphereLight){let J=t.get(L);J.skyColor.copy(L.color).multiplyScalar(Z),J.groundColor.copy(L.groundColor).multiplyScalar(Z),r.hemi[E]=J,E++}}R>0&&(e.has("OES_texture_float_linear")===!0?(r.rectAreaLTC1=Pe.LTC_FLOAT_1,r.rectAreaLTC2=Pe.LTC_FLOAT_2):(r.rectAreaLTC1=Pe.LTC_HALF_1,r.rectAreaLTC2=Pe.LTC_HALF_2)),r.ambient[0]=c,r.ambient[1]=d,r.ambient[2]=u;let N=r.hash;(N.sunLength!==f||N.directionalLength!==p||N.pointLength!==m||N.spotLength!==w||N.rectAreaLength!==R||N.hemiLength!==E||N.numSunShadows!==_||N.numDirectionalShadows!==T||N.numPointShadows!==P||N.numSpotShadows!==v||N.numSpotMaps!==b||N.numLightProbes!==W)&&(r.sun.length=f,r.directional.length=p,r.spot.length=w,r.rectArea.length=R,r.point.length=m,r.hemi.length=E,r.sunShadow.length=_,r.sunShadowMap.length=_,r.sunShadowMatrix.length=x,r.sunShadowCascade.length=x,r.directionalShadow.length=T,r.directionalShadowMap.length=T,r.directionalShadowMatrix.length=T,r.pointShadow.length=P,r.pointShadowMap.length=P,r.pointShadowMatrix.length=P,r.spotShadow.length=v,r.spotShadowMap.length=v,r.spotLightMatrix.length=v+b-U,r.spotLightMap.length=b,r.numSpotLightShadowsWithMaps=U,r.numLightProbes=W,N.sunLength=f,N.directionalLength=p,N.pointLength=m,N.spotLength=w,N.rectAreaLength=R,N.hemiLength=E,N.numSunShadows=_,N.numDirectionalShadows=T,N.numPointShadows=P,N.numSpotShadows=v,N.numSpotMaps=b,N.numLightProbes=W,r.version=Uy++)}function l(h,c){let d=0,u=0,f=0,_=0,x=0,p=0,m=c.matrixWorldInverse;for(let w=0,R=h.length;w<R;w++){let E=h[w];if(E.isSunLight){let T=r.sun[d];T.direction.setFromMatrixPosition(E.matrixWorld),T.direction.transformDirection(m),d++}else if(E.isDirectionalLight){let T=r.directional[u];T.direction.setFromMatrixPosition(E.matrixWorld),a.setFromMatrixPosition(E.target.matrixWorld),T.direction.sub(a),T.direction.transformDirection(m),u++}else if(E.isSpotLight){let T=r.spot[_];T.position.setFromMatrixPosition(E.matrixWorld),T.position.applyMatrix4(m),T.direction.setFromMatrixPosition(E.matrixWorld),a.setFromMatrixPosition(E.target.matrixWorld),T.direction.sub(a),T.direction.transformDirection(m),_++}else if(E.isRectAreaLight){let T=r.rectArea[x];T.position.setFromMatrixPosition(E.matrixWorld),T.position.applyMatrix4(m),s.identity(),n.copy(E.matrixWorld),n.premultiply(m),s.extractRotation(n),T.halfWidth.set(E.width*.5,0,0),T.halfHeight.set(0,E.height*.5,0),T.halfWidth.applyMatrix4(s),T.halfHeight.applyMatrix4(s),x++}else if(E.isPointLight){let T=r.point[f];T.position.setFromMatrixPosition(E.matrixWorld),T.position.applyMatrix4(m),f++}else if(E.isHemisphereLight){let T=r.hemi[p];T.direction.setFromMatrixPosition(E.matrixWorld),T.direction.transformDirection(m),p++}}}return{setup:o,setupView:l,state:r}}function _p(e){let t=new Fy(e),i=[],r=[],a=[];function n(d){c.camera=d,i.length=0,r.length=0,a.length=0}function s(d){d.isLightProbeGrid?a.push(d):i.push(d)}function o(d){r.push(d)}function l(){t.setup(i),a.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function h(d){t.setupView(i,d)}let c={lightsArray:i,shadowsArray:r,lightProbeGridArray:a,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:n,state:c,setupLights:l,setupLightsView:h,pushLight:s,pushShadow:o}}function ky(e){let t=new WeakMap;function i(a,n=0){let s=t.get(a),o;return s===void 0?(o=new _p(e),t.set(a,[o])):n>=s.length?(o=new _p(e),s.push(o)):o=s[n],o}function r(){t=new WeakMap}return{get:i,dispose:r}}var By=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,zy=`uniform sampler2D shadow_pass;
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
}`,Hy=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],Gy=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],vp=new ti,ws=new X,Xh=new X;function Vy(e,t,i){let r=new sl,a=new rt,n=new rt,s=new Ft,o=new Uv,l=new Ov,h={},c=i.maxTextureSize,d={[Ka]:Vi,[Vi]:Ka,[ra]:ra},u=new Bi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new rt},radius:{value:4}},vertexShader:By,fragmentShader:zy}),f=u.clone();f.defines.HORIZONTAL_PASS=1;let _=new pi;_.setAttribute("position",new ii(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Di(_,u),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Wo;let m=this.type;this.render=function(P,v,b){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||P.length===0)return;this.type===o_&&(Ye("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Wo);let U=e.getRenderTarget(),W=e.getActiveCubeFace(),N=e.getActiveMipmapLevel(),B=e.state;B.setBlending(Gn),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let I=m!==this.type;I&&v.traverse(function(L){L.material&&(Array.isArray(L.material)?L.material.forEach(G=>G.needsUpdate=!0):L.material.needsUpdate=!0)});for(let L=0,G=P.length;L<G;L++){let Z=P[L],O=Z.shadow;if(O===void 0){Ye("WebGLShadowMap:",Z,"has no shadow.");continue}if(O.autoUpdate===!1&&O.needsUpdate===!1)continue;a.copy(O.mapSize);let de=O.getFrameExtents();a.multiply(de),n.copy(O.mapSize),(a.x>c||a.y>c)&&(a.x>c&&(n.x=Math.floor(c/de.x),a.x=n.x*de.x,O.mapSize.x=n.x),a.y>c&&(n.y=Math.floor(c/de.y),a.y=n.y*de.y,O.mapSize.y=n.y));let J=e.state.buffers.depth.getReversed();if(O.camera._reversedDepth=J,O.map===null||I===!0){if(O.map!==null&&(O.map.depthTexture!==null&&(O.map.depthTexture.dispose(),O.map.depthTexture=null),O.map.dispose()),this.type===Ts){if(Z.isPointLight){Ye("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}O.map=new Hr(a.x,a.y,{format:Ja,type:Vr,minFilter:Gi,magFilter:Gi,generateMipmaps:!1}),O.map.texture.name=Z.name+".shadowMap",O.map.depthTexture=new Yn(a.x,a.y,Br),O.map.depthTexture.name=Z.name+".shadowMapDepth",O.map.depthTexture.format=Aa,O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=wi,O.map.depthTexture.magFilter=wi}else Z.isPointLight?(O.map=new Jc(a.x),O.map.depthTexture=new nm(a.x,Gr)):(O.map=new Hr(a.x,a.y),O.map.depthTexture=new Yn(a.x,a.y,Gr)),O.map.depthTexture.name=Z.name+".shadowMap",O.map.depthTexture.format=Aa,this.type===Wo?(O.map.depthTexture.compareFunction=J?zp:Bp,O.map.depthTexture.minFilter=Gi,O.map.depthTexture.magFilter=Gi):(O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=wi,O.map.depthTexture.magFilter=wi);O.camera.updateProjectionMatrix()}O.map.isWebGLCubeRenderTarget!==!0&&(O.map.width!==a.x||O.map.height!==a.y)&&O.map.setSize(a.x,a.y);let te=O.map.isWebGLCubeRenderTarget?6:O.getViewportCount();Z.isPointLight!==!0&&O.updateMatrices(Z,b);let ne=O.camera.layers.mask&4294967294?O.camera.layers:b.layers;for(let Le=0;Le<te;Le++){let K=O.getCamera(Le);if(Z.isPointLight){let re=O.camera,se=O.matrix,Ce=Z.distance||re.far;Ce!==re.far&&(re.far=Ce,re.updateProjectionMatrix()),ws.setFromMatrixPosition(Z.matrixWorld),re.position.copy(ws),Xh.copy(re.position),Xh.add(Hy[Le]),re.up.copy(Gy[Le]),re.lookAt(Xh),re.updateMatrixWorld(),se.makeTranslation(-ws.x,-ws.y,-ws.z),vp.multiplyMatrices(re.projectionMatrix,re.matrixWorldInverse),O._frustum.setFromProjectionMatrix(vp,re.coordinateSystem,re.reversedDepth)}if(O.map.isWebGLCubeRenderTarget)e.setRenderTarget(O.map,Le),e.clear();else{Le===0&&(e.setRenderTarget(O.map),e.clear());let re=O.getViewport(Le);s.set(n.x*re.x,n.y*re.y,n.x*re.z,n.y*re.w),B.viewport(s)}r=O.getFrustum(Le),E(v,b,K,Z,ne,this.type)}O.isPointLightShadow!==!0&&this.type===Ts&&w(O,b),O.needsUpdate=!1}m=this.type,p.needsUpdate=!1,e.setRenderTarget(U,W,N)};function w(P,v){let b=t.update(x);u.defines.VSM_SAMPLES!==P.blurSamples&&(u.defines.VSM_SAMPLES=P.blurSamples,f.defines.VSM_SAMPLES=P.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),P.mapPass===null?P.mapPass=new Hr(a.x,a.y,{format:Ja,type:Vr}):(P.mapPass.width!==P.map.width||P.mapPass.height!==P.map.height)&&P.mapPass.setSize(P.map.width,P.map.height),u.uniforms.shadow_pass.value=P.map.depthTexture,u.uniforms.resolution.value.set(P.map.width,P.map.height),u.uniforms.radius.value=P.radius,e.setRenderTarget(P.mapPass),e.clear(),e.renderBufferDirect(v,null,b,u,x,null),f.uniforms.shadow_pass.value=P.mapPass.texture,f.uniforms.resolution.value.set(P.map.width,P.map.height),f.uniforms.radius.value=P.radius,e.setRenderTarget(P.map),e.clear(),e.renderBufferDirect(v,null,b,f,x,null)}function R(P,v,b,U){let W=null,N=b.isPointLight===!0?P.customDistanceMaterial:P.customDepthMaterial;if(N!==void 0)W=N;else if(W=b.isPointLight===!0?l:o,e.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let B=W.uuid,I=v.uuid,L=h[B];L===void 0&&(L={},h[B]=L);let G=L[I];G===void 0&&(G=W.clone(),L[I]=G,v.addEventListener("dispose",T)),W=G}if(W.visible=v.visible,W.wireframe=v.wireframe,U===Ts?W.side=v.shadowSide!==null?v.shadowSide:v.side:W.side=v.shadowSide!==null?v.shadowSide:d[v.side],W.alphaMap=v.alphaMap,W.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,W.map=v.map,W.clipShadows=v.clipShadows,W.clippingPlanes=v.clippingPlanes,W.clipIntersection=v.clipIntersection,W.displacementMap=v.displacementMap,W.displacementScale=v.displacementScale,W.displacementBias=v.displacementBias,W.wireframeLinewidth=v.wireframeLinewidth,W.linewidth=v.linewidth,b.isPointLight===!0&&W.isMeshDistanceMaterial===!0){let B=e.properties.get(W);B.light=b}return W}function E(P,v,b,U,W,N){if(P.visible===!1)return;if(P.layers.test(W)&&(P.isMesh||P.isLine||P.isPoints)&&(P.castShadow||P.receiveShadow&&N===Ts)&&(!P.frustumCulled||P.intersectsFrustum(r))){P.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,P.matrixWorld);let I=t.update(P),L=P.material;if(Array.isArray(L)){let G=I.groups;for(let Z=0,O=G.length;Z<O;Z++){let de=G[Z],J=L[de.materialIndex];if(J&&J.visible){let te=R(P,J,U,N);P.onBeforeShadow(e,P,v,b,I,te,de),e.renderBufferDirect(b,null,I,te,P,de),P.onAfterShadow(e,P,v,b,I,te,de)}}}else if(L.visible){let G=R(P,L,U,N);P.onBeforeShadow(e,P,v,b,I,G,null),e.renderBufferDirect(b,null,I,G,P,null),P.onAfterShadow(e,P,v,b,I,G,null)}}let B=P.children;for(let I=0,L=B.length;I<L;I++)E(B[I],v,b,U,W,N)}function T(P){P.target.removeEventListener("dispose",T);for(let v in h){let b=h[v],U=P.target.uuid;U in b&&(b[U].dispose(),delete b[U])}}}function Wy(e,t){function i(){let F=!1,Q=new Ft,ue=null,me=new Ft(0,0,0,0);return{setMask:function(Te){ue!==Te&&!F&&(e.colorMask(Te,Te,Te,Te),ue=Te)},setLocked:function(Te){F=Te},setClear:function(Te,Ee,Ve,fe,Je){Je===!0&&(Te*=fe,Ee*=fe,Ve*=fe),Q.set(Te,Ee,Ve,fe),me.equals(Q)===!1&&(e.clearColor(Te,Ee,Ve,fe),me.copy(Q))},reset:function(){F=!1,ue=null,me.set(-1,0,0,0)}}}function r(){let F=!1,Q=!1,ue=null,me=null,Te=null;return{setReversed:function(Ee){if(Q!==Ee){let Ve=t.get("EXT_clip_control");Ee?Ve.clipControlEXT(Ve.LOWER_LEFT_EXT,Ve.ZERO_TO_ONE_EXT):Ve.clipControlEXT(Ve.LOWER_LEFT_EXT,Ve.NEGATIVE_ONE_TO_ONE_EXT),Q=Ee;let fe=Te;Te=null,this.setClear(fe)}},getReversed:function(){return Q},setTest:function(Ee){Ee?le(e.DEPTH_TEST):Fe(e.DEPTH_TEST)},setMask:function(Ee){ue!==Ee&&!F&&(e.depthMask(Ee),ue=Ee)},setFunc:function(Ee){if(Q&&(Ee=G_[Ee]),me!==Ee){switch(Ee){case qh:e.depthFunc(e.NEVER);break;case $h:e.depthFunc(e.ALWAYS);break;case Kh:e.depthFunc(e.LESS);break;case Ls:e.depthFunc(e.LEQUAL);break;case Jh:e.depthFunc(e.EQUAL);break;case Zh:e.depthFunc(e.GEQUAL);break;case Qh:e.depthFunc(e.GREATER);break;case ec:e.depthFunc(e.NOTEQUAL);break;default:e.depthFunc(e.LEQUAL)}me=Ee}},setLocked:function(Ee){F=Ee},setClear:function(Ee){Te!==Ee&&(Te=Ee,Q&&(Ee=1-Ee),e.clearDepth(Ee))},reset:function(){F=!1,ue=null,me=null,Te=null,Q=!1}}}function a(){let F=!1,Q=null,ue=null,me=null,Te=null,Ee=null,Ve=null,fe=null,Je=null;return{setTest:function(He){F||(He?le(e.STENCIL_TEST):Fe(e.STENCIL_TEST))},setMask:function(He){Q!==He&&!F&&(e.stencilMask(He),Q=He)},setFunc:function(He,Xe,Ae){(ue!==He||me!==Xe||Te!==Ae)&&(e.stencilFunc(He,Xe,Ae),ue=He,me=Xe,Te=Ae)},setOp:function(He,Xe,Ae){(Ee!==He||Ve!==Xe||fe!==Ae)&&(e.stencilOp(He,Xe,Ae),Ee=He,Ve=Xe,fe=Ae)},setLocked:function(He){F=He},setClear:function(He){Je!==He&&(e.clearStencil(He),Je=He)},reset:function(){F=!1,Q=null,ue=null,me=null,Te=null,Ee=null,Ve=null,fe=null,Je=null}}}let n=new i,s=new r,o=new a,l={},h=new WeakMap,c={},d={},u={},f=new WeakMap,_=[],x=null,p=!1,m=null,w=null,R=null,E=null,T=null,P=null,v=null,b=new lt(0,0,0),U=0,W=!1,N=null,B=null,I=null,L=null,G=null,Z=e.getParameter(e.MAX_COMBINED_TEXTURE_IMAGE_UNITS),O=!1,de=0,J=e.getParameter(e.VERSION);J.indexOf("WebGL")!==-1?(de=parseFloat(/^WebGL (\d)/.exec(J)[1]),O=de>=1):J.indexOf("OpenGL ES")!==-1&&(de=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),O=de>=2);let te=null,ne={},Le=e.getParameter(e.SCISSOR_BOX),K=e.getParameter(e.VIEWPORT),re=new Ft().fromArray(Le),se=new Ft().fromArray(K);function Ce(F,Q,ue,me){let Te=new Uint8Array(4),Ee=e.createTexture();e.bindTexture(F,Ee),e.texParameteri(F,e.TEXTURE_MIN_FILTER,e.NEAREST),e.texParameteri(F,e.TEXTURE_MAG_FILTER,e.NEAREST);for(let Ve=0;Ve<ue;Ve++)F===e.TEXTURE_3D||F===e.TEXTURE_2D_ARRAY?e.texImage3D(Q,0,e.RGBA,1,1,me,0,e.RGBA,e.UNSIGNED_BYTE,Te):e.texImage2D(Q+Ve,0,e.RGBA,1,1,0,e.RGBA,e.UNSIGNED_BYTE,Te);return Ee}let Re={};Re[e.TEXTURE_2D]=Ce(e.TEXTURE_2D,e.TEXTURE_2D,1),Re[e.TEXTURE_CUBE_MAP]=Ce(e.TEXTURE_CUBE_MAP,e.TEXTURE_CUBE_MAP_POSITIVE_X,6),Re[e.TEXTURE_2D_ARRAY]=Ce(e.TEXTURE_2D_ARRAY,e.TEXTURE_2D_ARRAY,1,1),Re[e.TEXTURE_3D]=Ce(e.TEXTURE_3D,e.TEXTURE_3D,1,1),n.setClear(0,0,0,1),s.setClear(1),o.setClear(0),le(e.DEPTH_TEST),s.setFunc(Ls),Nt(!1),vt(cf),le(e.CULL_FACE),$e(Gn);function le(F){c[F]!==!0&&(e.enable(F),c[F]=!0)}function Fe(F){c[F]!==!1&&(e.disable(F),c[F]=!1)}function We(F,Q){return u[F]!==Q?(e.bindFramebuffer(F,Q),u[F]=Q,F===e.DRAW_FRAMEBUFFER&&(u[e.FRAMEBUFFER]=Q),F===e.FRAMEBUFFER&&(u[e.DRAW_FRAMEBUFFER]=Q),!0):!1}function we(F,Q){let ue=_,me=!1;if(F){ue=f.get(Q),ue===void 0&&(ue=[],f.set(Q,ue));let Te=F.textures;if(ue.length!==Te.length||ue[0]!==e.COLOR_ATTACHMENT0){for(let Ee=0,Ve=Te.length;Ee<Ve;Ee++)ue[Ee]=e.COLOR_ATTACHMENT0+Ee;ue.length=Te.length,me=!0}}else ue[0]!==e.BACK&&(ue[0]=e.BACK,me=!0);me&&e.drawBuffers(ue)}function at(F){return x!==F?(e.useProgram(F),x=F,!0):!1}let _t={[Fn]:e.FUNC_ADD,[h_]:e.FUNC_SUBTRACT,[c_]:e.FUNC_REVERSE_SUBTRACT};_t[u_]=e.MIN,_t[d_]=e.MAX;let Mt={[f_]:e.ZERO,[p_]:e.ONE,[m_]:e.SRC_COLOR,[Sp]:e.SRC_ALPHA,[S_]:e.SRC_ALPHA_SATURATE,[x_]:e.DST_COLOR,[__]:e.DST_ALPHA,[g_]:e.ONE_MINUS_SRC_COLOR,[yp]:e.ONE_MINUS_SRC_ALPHA,[M_]:e.ONE_MINUS_DST_COLOR,[v_]:e.ONE_MINUS_DST_ALPHA,[y_]:e.CONSTANT_COLOR,[E_]:e.ONE_MINUS_CONSTANT_COLOR,[b_]:e.CONSTANT_ALPHA,[w_]:e.ONE_MINUS_CONSTANT_ALPHA};function $e(F,Q,ue,me,Te,Ee,Ve,fe,Je,He){if(F===Gn){p===!0&&(Fe(e.BLEND),p=!1);return}if(p===!1&&(le(e.BLEND),p=!0),F!==l_){if(F!==m||He!==W){if((w!==Fn||T!==Fn)&&(e.blendEquation(e.FUNC_ADD),w=Fn,T=Fn),He)switch(F){case Rs:e.blendFuncSeparate(e.ONE,e.ONE_MINUS_SRC_ALPHA,e.ONE,e.ONE_MINUS_SRC_ALPHA);break;case uf:e.blendFunc(e.ONE,e.ONE);break;case df:e.blendFuncSeparate(e.ZERO,e.ONE_MINUS_SRC_COLOR,e.ZERO,e.ONE);break;case ff:e.blendFuncSeparate(e.DST_COLOR,e.ONE_MINUS_SRC_ALPHA,e.ZERO,e.ONE);break;default:Ze("WebGLState: Invalid blending: ",F);break}else switch(F){case Rs:e.blendFuncSeparate(e.SRC_ALPHA,e.ONE_MINUS_SRC_ALPHA,e.ONE,e.ONE_MINUS_SRC_ALPHA);break;case uf:e.blendFuncSeparate(e.SRC_ALPHA,e.ONE,e.ONE,e.ONE);break;case df:Ze("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ff:Ze("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ze("WebGLState: Invalid blending: ",F);break}R=null,E=null,P=null,v=null,b.set(0,0,0),U=0,m=F,W=He}return}Te=Te||Q,Ee=Ee||ue,Ve=Ve||me,(Q!==w||Te!==T)&&(e.blendEquationSeparate(_t[Q],_t[Te]),w=Q,T=Te),(ue!==R||me!==E||Ee!==P||Ve!==v)&&(e.blendFuncSeparate(Mt[ue],Mt[me],Mt[Ee],Mt[Ve]),R=ue,E=me,P=Ee,v=Ve),(fe.equals(b)===!1||Je!==U)&&(e.blendColor(fe.r,fe.g,fe.b,Je),b.copy(fe),U=Je),m=F,W=!1}function St(F,Q){F.side===ra?Fe(e.CULL_FACE):le(e.CULL_FACE);let ue=F.side===Vi;Q&&(ue=!ue),Nt(ue),F.blending===Rs&&F.transparent===!1?$e(Gn):$e(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),s.setFunc(F.depthFunc),s.setTest(F.depthTest),s.setMask(F.depthWrite),n.setMask(F.colorWrite);let me=F.stencilWrite;o.setTest(me),me&&(o.setMask(F.stencilWriteMask),o.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),o.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),mi(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?le(e.SAMPLE_ALPHA_TO_COVERAGE):Fe(e.SAMPLE_ALPHA_TO_COVERAGE)}function Nt(F){N!==F&&(F?e.frontFace(e.CW):e.frontFace(e.CCW),N=F)}function vt(F){F!==n_?(le(e.CULL_FACE),F!==B&&(F===cf?e.cullFace(e.BACK):F===s_?e.cullFace(e.FRONT):e.cullFace(e.FRONT_AND_BACK))):Fe(e.CULL_FACE),B=F}function Zt(F){F!==I&&(O&&e.lineWidth(F),I=F)}function mi(F,Q,ue){F?(le(e.POLYGON_OFFSET_FILL),(L!==Q||G!==ue)&&(L=Q,G=ue,s.getReversed()&&(Q=-Q,ue=-ue),e.polygonOffset(Q,ue))):Fe(e.POLYGON_OFFSET_FILL)}function Ut(F){F?le(e.SCISSOR_TEST):Fe(e.SCISSOR_TEST)}function kt(F){F===void 0&&(F=e.TEXTURE0+Z-1),te!==F&&(e.activeTexture(F),te=F)}function V(F,Q,ue){ue===void 0&&(te===null?ue=e.TEXTURE0+Z-1:ue=te);let me=ne[ue];me===void 0&&(me={type:void 0,texture:void 0},ne[ue]=me),(me.type!==F||me.texture!==Q)&&(te!==ue&&(e.activeTexture(ue),te=ue),e.bindTexture(F,Q||Re[F]),me.type=F,me.texture=Q)}function oi(){let F=ne[te];F!==void 0&&F.type!==void 0&&(e.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function ht(){try{e.compressedTexImage2D(...arguments)}catch(F){Ze("WebGLState:",F)}}function ve(){try{e.compressedTexImage3D(...arguments)}catch(F){Ze("WebGLState:",F)}}function ae(){try{e.texSubImage2D(...arguments)}catch(F){Ze("WebGLState:",F)}}function Ke(){try{e.texSubImage3D(...arguments)}catch(F){Ze("WebGLState:",F)}}function Oe(){try{e.compressedTexSubImage2D(...arguments)}catch(F){Ze("WebGLState:",F)}}function je(){try{e.compressedTexSubImage3D(...arguments)}catch(F){Ze("WebGLState:",F)}}function Ot(){try{e.texStorage2D(...arguments)}catch(F){Ze("WebGLState:",F)}}function A(){try{e.texStorage3D(...arguments)}catch(F){Ze("WebGLState:",F)}}function M(){try{e.texImage2D(...arguments)}catch(F){Ze("WebGLState:",F)}}function j(){try{e.texImage3D(...arguments)}catch(F){Ze("WebGLState:",F)}}function he(F){return d[F]!==void 0?d[F]:e.getParameter(F)}function ie(F,Q){d[F]!==Q&&(e.pixelStorei(F,Q),d[F]=Q)}function xe(F){re.equals(F)===!1&&(e.scissor(F.x,F.y,F.z,F.w),re.copy(F))}function Me(F){se.equals(F)===!1&&(e.viewport(F.x,F.y,F.z,F.w),se.copy(F))}function z(F,Q){let ue=h.get(Q);ue===void 0&&(ue=new WeakMap,h.set(Q,ue));let me=ue.get(F);me===void 0&&(me=e.getUniformBlockIndex(Q,F.name),e.uniformBlockBinding(Q,me,me),ue.set(F,me))}function ce(F,Q,ue){let me=h.get(Q).get(F);l[me]!==ue&&(e.bindBufferBase(e.UNIFORM_BUFFER,me,ue),l[me]=ue)}function ye(){e.disable(e.BLEND),e.disable(e.CULL_FACE),e.disable(e.DEPTH_TEST),e.disable(e.POLYGON_OFFSET_FILL),e.disable(e.SCISSOR_TEST),e.disable(e.STENCIL_TEST),e.disable(e.SAMPLE_ALPHA_TO_COVERAGE),e.blendEquation(e.FUNC_ADD),e.blendFunc(e.ONE,e.ZERO),e.blendFuncSeparate(e.ONE,e.ZERO,e.ONE,e.ZERO),e.blendColor(0,0,0,0),e.colorMask(!0,!0,!0,!0),e.clearColor(0,0,0,0),e.depthMask(!0),e.depthFunc(e.LESS),s.setReversed(!1),e.clearDepth(1),e.stencilMask(4294967295),e.stencilFunc(e.ALWAYS,0,4294967295),e.stencilOp(e.KEEP,e.KEEP,e.KEEP),e.clearStencil(0),e.cullFace(e.BACK),e.frontFace(e.CCW),e.polygonOffset(0,0),e.activeTexture(e.TEXTURE0),e.bindFramebuffer(e.FRAMEBUFFER,null),e.bindFramebuffer(e.DRAW_FRAMEBUFFER,null),e.bindFramebuffer(e.READ_FRAMEBUFFER,null),e.useProgram(null),e.lineWidth(1),e.scissor(0,0,e.canvas.width,e.canvas.height),e.viewport(0,0,e.canvas.width,e.canvas.height),e.pixelStorei(e.PACK_ALIGNMENT,4),e.pixelStorei(e.UNPACK_ALIGNMENT,4),e.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,!1),e.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),e.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,e.BROWSER_DEFAULT_WEBGL),e.pixelStorei(e.PACK_ROW_LENGTH,0),e.pixelStorei(e.PACK_SKIP_PIXELS,0),e.pixelStorei(e.PACK_SKIP_ROWS,0),e.pixelStorei(e.UNPACK_ROW_LENGTH,0),e.pixelStorei(e.UNPACK_IMAGE_HEIGHT,0),e.pixelStorei(e.UNPACK_SKIP_PIXELS,0),e.pixelStorei(e.UNPACK_SKIP_ROWS,0),e.pixelStorei(e.UNPACK_SKIP_IMAGES,0),c={},d={},te=null,ne={},u={},l={},f=new WeakMap,_=[],x=null,p=!1,m=null,w=null,R=null,E=null,T=null,P=null,v=null,b=new lt(0,0,0),U=0,W=!1,N=null,B=null,I=null,L=null,G=null,re.set(0,0,e.canvas.width,e.canvas.height),se.set(0,0,e.canvas.width,e.canvas.height),n.reset(),s.reset(),o.reset()}return{buffers:{color:n,depth:s,stencil:o},enable:le,disable:Fe,bindFramebuffer:We,drawBuffers:we,useProgram:at,setBlending:$e,setMaterial:St,setFlipSided:Nt,setCullFace:vt,setLineWidth:Zt,setPolygonOffset:mi,setScissorTest:Ut,activeTexture:kt,bindTexture:V,unbindTexture:oi,compressedTexImage2D:ht,compressedTexImage3D:ve,texImage2D:M,texImage3D:j,pixelStorei:ie,getParameter:he,updateUBOMapping:z,uniformBlockBinding:ce,texStorage2D:Ot,texStorage3D:A,texSubImage2D:ae,texSubImage3D:Ke,compressedTexSubImage2D:Oe,compressedTexSubImage3D:je,scissor:xe,viewport:Me,reset:ye}}function jy(e,t,i,r,a,n,s){let o=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),h=new rt,c=new WeakMap,d=new Set,u,f=new WeakMap,_=new Set,x=new FinalizationRegistry(A=>_.delete(A)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(A,M){return p?new OffscreenCanvas(A,M):nl("canvas")}function w(A,M,j){let he=1,ie=Ot(A);if((ie.width>j||ie.height>j)&&(he=j/Math.max(ie.width,ie.height)),he<1)if(typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&A instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&A instanceof ImageBitmap||typeof VideoFrame<"u"&&A instanceof VideoFrame){let xe=Math.floor(he*ie.width),Me=Math.floor(he*ie.height);u===void 0&&(u=m(xe,Me));let z=M?m(xe,Me):u;return z.width=xe,z.height=Me,z.getContext("2d").drawImage(A,0,0,xe,Me),Ye("WebGLRenderer: Texture has been resized from ("+ie.width+"x"+ie.height+") to ("+xe+"x"+Me+")."),z}else return"data"in A&&Ye("WebGLRenderer: Image in DataTexture is too big ("+ie.width+"x"+ie.height+")."),A;return A}function R(A){return A.generateMipmaps}function E(A){e.generateMipmap(A)}function T(A){return A.isWebGLCubeRenderTarget?e.TEXTURE_CUBE_MAP:A.isWebGL3DRenderTarget?e.TEXTURE_3D:A.isWebGLArrayRenderTarget||A.isCompressedArrayTexture?e.TEXTURE_2D_ARRAY:e.TEXTURE_2D}function P(A,M,j,he,ie,xe=!1){if(A!==null){if(e[A]!==void 0)return e[A];Ye("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+A+"'")}let Me;he&&(Me=t.get("EXT_texture_norm16"),Me||Ye("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let z=M;if(M===e.RED&&(j===e.FLOAT&&(z=e.R32F),j===e.HALF_FLOAT&&(z=e.R16F),j===e.UNSIGNED_BYTE&&(z=e.R8),j===e.UNSIGNED_SHORT&&Me&&(z=Me.R16_EXT),j===e.SHORT&&Me&&(z=Me.R16_SNORM_EXT)),M===e.RED_INTEGER&&(j===e.UNSIGNED_BYTE&&(z=e.R8UI),j===e.UNSIGNED_SHORT&&(z=e.R16UI),j===e.UNSIGNED_INT&&(z=e.R32UI),j===e.BYTE&&(z=e.R8I),j===e.SHORT&&(z=e.R16I),j===e.INT&&(z=e.R32I)),M===e.RG&&(j===e.FLOAT&&(z=e.RG32F),j===e.HALF_FLOAT&&(z=e.RG16F),j===e.UNSIGNED_BYTE&&(z=e.RG8),j===e.UNSIGNED_SHORT&&Me&&(z=Me.RG16_EXT),j===e.SHORT&&Me&&(z=Me.RG16_SNORM_EXT)),M===e.RG_INTEGER&&(j===e.UNSIGNED_BYTE&&(z=e.RG8UI),j===e.UNSIGNED_SHORT&&(z=e.RG16UI),j===e.UNSIGNED_INT&&(z=e.RG32UI),j===e.BYTE&&(z=e.RG8I),j===e.SHORT&&(z=e.RG16I),j===e.INT&&(z=e.RG32I)),M===e.RGB_INTEGER&&(j===e.UNSIGNED_BYTE&&(z=e.RGB8UI),j===e.UNSIGNED_SHORT&&(z=e.RGB16UI),j===e.UNSIGNED_INT&&(z=e.RGB32UI),j===e.BYTE&&(z=e.RGB8I),j===e.SHORT&&(z=e.RGB16I),j===e.INT&&(z=e.RGB32I)),M===e.RGBA_INTEGER&&(j===e.UNSIGNED_BYTE&&(z=e.RGBA8UI),j===e.UNSIGNED_SHORT&&(z=e.RGBA16UI),j===e.UNSIGNED_INT&&(z=e.RGBA32UI),j===e.BYTE&&(z=e.RGBA8I),j===e.SHORT&&(z=e.RGBA16I),j===e.INT&&(z=e.RGBA32I)),M===e.RGB&&(j===e.UNSIGNED_SHORT&&Me&&(z=Me.RGB16_EXT),j===e.SHORT&&Me&&(z=Me.RGB16_SNORM_EXT),j===e.UNSIGNED_INT_5_9_9_9_REV&&(z=e.RGB9_E5),j===e.UNSIGNED_INT_10F_11F_11F_REV&&(z=e.R11F_G11F_B10F)),M===e.RGBA){let ce=xe?rl:ft.getTransfer(ie);j===e.FLOAT&&(z=e.RGBA32F),j===e.HALF_FLOAT&&(z=e.RGBA16F),j===e.UNSIGNED_BYTE&&(z=ce===Pt?e.SRGB8_ALPHA8:e.RGBA8),j===e.UNSIGNED_SHORT&&Me&&(z=Me.RGBA16_EXT),j===e.SHORT&&Me&&(z=Me.RGBA16_SNORM_EXT),j===e.UNSIGNED_SHORT_4_4_4_4&&(z=e.RGBA4),j===e.UNSIGNED_SHORT_5_5_5_1&&(z=e.RGB5_A1)}return(z===e.R16F||z===e.R32F||z===e.RG16F||z===e.RG32F||z===e.RGBA16F||z===e.RGBA32F)&&t.get("EXT_color_buffer_float"),z}function v(A,M){let j;return A?M===null||M===Gr||M===jn?j=e.DEPTH24_STENCIL8:M===Br?j=e.DEPTH32F_STENCIL8:M===Ns&&(j=e.DEPTH24_STENCIL8,Ye("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Gr||M===jn?j=e.DEPTH_COMPONENT24:M===Br?j=e.DEPTH_COMPONENT32F:M===Ns&&(j=e.DEPTH_COMPONENT16),j}function b(A,M){return R(A)===!0||A.isFramebufferTexture&&A.minFilter!==wi&&A.minFilter!==Gi?Math.log2(Math.max(M.width,M.height))+1:A.mipmaps.length>0?A.mipmaps.length:A.isCompressedTexture&&Array.isArray(A.image)?M.mipmaps.length:1}function U(A){let M=new WeakRef(A);r.get(A).__ref=M,_.add(M),x.register(A,M,M)}function W(A){let M=r.get(A).__ref;M!==void 0&&(_.delete(M),x.unregister(M))}function N(A){I(A.target)}function B(A){L(A.target)}function I(A){A.removeEventListener("dispose",N),W(A),Z(A),A.isVideoTexture&&c.delete(A),A.isHTMLTexture&&d.delete(A)}function L(A){A.removeEventListener("dispose",B),W(A),de(A)}function G(){for(let A of _){let M=A.deref();M!==void 0&&(M.isRenderTarget===!0?L(M):I(M))}_.clear(),d.clear()}function Z(A){let M=r.get(A);if(M.__webglInit===void 0)return;let j=A.source,he=f.get(j);if(he){let ie=he[M.__cacheKey];ie.usedTimes--,ie.usedTimes===0&&O(A),Object.keys(he).length===0&&f.delete(j)}r.remove(A)}function O(A){let M=r.get(A);e.deleteTexture(M.__webglTexture);let j=A.source,he=f.get(j);delete he[M.__cacheKey],s.memory.textures--}function de(A){let M=r.get(A);M.__depthDisposeCallback&&M.__depthDisposeCallback();let j=A.depthTexture;if(j&&j.renderTarget===A&&I(j),A.isWebGLCubeRenderTarget)for(let ie=0;ie<6;ie++){if(Array.isArray(M.__webglFramebuffer[ie]))for(let xe=0;xe<M.__webglFramebuffer[ie].length;xe++)e.deleteFramebuffer(M.__webglFramebuffer[ie][xe]);else e.deleteFramebuffer(M.__webglFramebuffer[ie]);M.__webglDepthbuffer&&e.deleteRenderbuffer(M.__webglDepthbuffer[ie])}else{if(Array.isArray(M.__webglFramebuffer))for(let ie=0;ie<M.__webglFramebuffer.length;ie++)e.deleteFramebuffer(M.__webglFramebuffer[ie]);else e.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&e.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&e.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let ie=0;ie<M.__webglColorRenderbuffer.length;ie++)M.__webglColorRenderbuffer[ie]&&e.deleteRenderbuffer(M.__webglColorRenderbuffer[ie]);M.__webglDepthRenderbuffer&&e.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let he=A.textures;for(let ie=0,xe=he.length;ie<xe;ie++){let Me=r.get(he[ie]);Me.__webglTexture&&(e.deleteTexture(Me.__webglTexture),s.memory.textures--),r.remove(he[ie])}r.remove(A)}let J=0;function te(){J=0}function ne(){return J}function Le(A){J=A}function K(){let A=J;return A>=a.maxTextures&&Ye("WebGLTextures: Trying to use "+(A+1)+" texture units while this GPU supports only "+a.maxTextures),J+=1,A}function re(A){let M=[];return M.push(A.wrapS),M.push(A.wrapT),M.push(A.wrapR||0),M.push(A.magFilter),M.push(A.minFilter),M.push(A.anisotropy),M.push(A.internalFormat),M.push(A.format),M.push(A.type),M.push(A.generateMipmaps),M.push(A.mipmapsAutoUpdate),M.push(A.premultiplyAlpha),M.push(A.flipY),M.push(A.unpackAlignment),M.push(A.colorSpace),M.join()}function se(A,M){let j=r.get(A);if(A.isVideoTexture&&Oe(A),A.isRenderTargetTexture===!1&&A.isExternalTexture!==!0&&A.version>0&&j.__version!==A.version){let he=A.image;if(he===null)Ye("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)Ye("WebGLRenderer: Texture marked for update but image is incomplete");else{St(j,A,M);return}}else A.isExternalTexture&&(j.__webglTexture=A.sourceTexture?A.sourceTexture:null);i.bindTexture(e.TEXTURE_2D,j.__webglTexture,e.TEXTURE0+M)}function Ce(A,M){let j=r.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&j.__version!==A.version){St(j,A,M);return}else A.isExternalTexture&&(j.__webglTexture=A.sourceTexture?A.sourceTexture:null);i.bindTexture(e.TEXTURE_2D_ARRAY,j.__webglTexture,e.TEXTURE0+M)}function Re(A,M){let j=r.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&j.__version!==A.version){St(j,A,M);return}i.bindTexture(e.TEXTURE_3D,j.__webglTexture,e.TEXTURE0+M)}function le(A,M){let j=r.get(A);if(A.version>0&&j.__version!==A.version){Nt(j,A,M);return}i.bindTexture(e.TEXTURE_CUBE_MAP,j.__webglTexture,e.TEXTURE0+M)}let Fe={[tc]:e.REPEAT,[aa]:e.CLAMP_TO_EDGE,[ic]:e.MIRRORED_REPEAT},We={[wi]:e.NEAREST,[R_]:e.NEAREST_MIPMAP_NEAREST,[go]:e.NEAREST_MIPMAP_LINEAR,[Gi]:e.LINEAR,[Sh]:e.LINEAR_MIPMAP_NEAREST,[wa]:e.LINEAR_MIPMAP_LINEAR},we={[D_]:e.NEVER,[Hp]:e.ALWAYS,[N_]:e.LESS,[Bp]:e.LEQUAL,[I_]:e.EQUAL,[zp]:e.GEQUAL,[U_]:e.GREATER,[O_]:e.NOTEQUAL};function at(A,M){if(M.type===Br&&t.has("OES_texture_float_linear")===!1&&(M.magFilter===Gi||M.magFilter===Sh||M.magFilter===go||M.magFilter===wa||M.minFilter===Gi||M.minFilter===Sh||M.minFilter===go||M.minFilter===wa)&&Ye("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),e.texParameteri(A,e.TEXTURE_WRAP_S,Fe[M.wrapS]),e.texParameteri(A,e.TEXTURE_WRAP_T,Fe[M.wrapT]),(A===e.TEXTURE_3D||A===e.TEXTURE_2D_ARRAY)&&e.texParameteri(A,e.TEXTURE_WRAP_R,Fe[M.wrapR]),e.texParameteri(A,e.TEXTURE_MAG_FILTER,We[M.magFilter]),e.texParameteri(A,e.TEXTURE_MIN_FILTER,We[M.minFilter]),M.compareFunction&&(e.texParameteri(A,e.TEXTURE_COMPARE_MODE,e.COMPARE_REF_TO_TEXTURE),e.texParameteri(A,e.TEXTURE_COMPARE_FUNC,we[M.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===wi||M.minFilter!==go&&M.minFilter!==wa||M.type===Br&&t.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||r.get(M).__currentAnisotropy){let j=t.get("EXT_texture_filter_anisotropic");e.texParameterf(A,j.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,a.getMaxAnisotropy())),r.get(M).__currentAnisotropy=M.anisotropy}}}function _t(A,M){let j=!1;A.__webglInit===void 0&&(A.__webglInit=!0,M.addEventListener("dispose",N),U(M));let he=M.source,ie=f.get(he);ie===void 0&&(ie={},f.set(he,ie));let xe=re(M);if(xe!==A.__cacheKey){ie[xe]===void 0&&(ie[xe]={texture:e.createTexture(),usedTimes:0},s.memory.textures++,j=!0),ie[xe].usedTimes++;let Me=ie[A.__cacheKey];Me!==void 0&&(ie[A.__cacheKey].usedTimes--,Me.usedTimes===0&&O(M)),A.__cacheKey=xe,A.__webglTexture=ie[xe].texture}return j}function Mt(A,M,j){return Math.floor(Math.floor(A/j)/M)}function $e(A,M,j,he){let ie=A.updateRanges;if(ie.length===0)i.texSubImage2D(e.TEXTURE_2D,0,0,0,M.width,M.height,j,he,M.data);else{ie.sort((ye,F)=>ye.start-F.start);let xe=0;for(let ye=1;ye<ie.length;ye++){let F=ie[xe],Q=ie[ye],ue=F.start+F.count,me=Mt(Q.start,M.width,4),Te=Mt(F.start,M.width,4);Q.start<=ue+1&&me===Te&&Mt(Q.start+Q.count-1,M.width,4)===me?F.count=Math.max(F.count,Q.start+Q.count-F.start):(++xe,ie[xe]=Q)}ie.length=xe+1;let Me=i.getParameter(e.UNPACK_ROW_LENGTH),z=i.getParameter(e.UNPACK_SKIP_PIXELS),ce=i.getParameter(e.UNPACK_SKIP_ROWS);i.pixelStorei(e.UNPACK_ROW_LENGTH,M.width);for(let ye=0,F=ie.length;ye<F;ye++){let Q=ie[ye],ue=Math.floor(Q.start/4),me=Math.ceil(Q.count/4),Te=ue%M.width,Ee=Math.floor(ue/M.width),Ve=me,fe=1;i.pixelStorei(e.UNPACK_SKIP_PIXELS,Te),i.pixelStorei(e.UNPACK_SKIP_ROWS,Ee),i.texSubImage2D(e.TEXTURE_2D,0,Te,Ee,Ve,fe,j,he,M.data)}A.clearUpdateRanges(),i.pixelStorei(e.UNPACK_ROW_LENGTH,Me),i.pixelStorei(e.UNPACK_SKIP_PIXELS,z),i.pixelStorei(e.UNPACK_SKIP_ROWS,ce)}}function St(A,M,j){let he=e.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(he=e.TEXTURE_2D_ARRAY),M.isData3DTexture&&(he=e.TEXTURE_3D);let ie=_t(A,M),xe=M.source;i.bindTexture(he,A.__webglTexture,e.TEXTURE0+j);let Me=r.get(xe);if(xe.version!==Me.__version||ie===!0){if(i.activeTexture(e.TEXTURE0+j),!(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)){let fe=ft.getPrimaries(ft.workingColorSpace),Je=M.colorSpace===ba?null:ft.getPrimaries(M.colorSpace),He=M.colorSpace===ba||fe===Je?e.NONE:e.BROWSER_DEFAULT_WEBGL;i.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,M.flipY),i.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),i.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,He)}i.pixelStorei(e.UNPACK_ALIGNMENT,M.unpackAlignment);let z=w(M.image,!1,a.maxTextureSize);z=je(M,z);let ce=n.convert(M.format,M.colorSpace),ye=n.convert(M.type),F=P(M.internalFormat,ce,ye,M.normalized,M.colorSpace,M.isVideoTexture);at(he,M);let Q,ue=M.mipmaps,me=M.isVideoTexture!==!0,Te=Me.__version===void 0||ie===!0,Ee=xe.dataReady,Ve=b(M,z);if(M.isDepthTexture)F=v(M.format===Ta,M.type),Te&&(me?i.texStorage2D(e.TEXTURE_2D,1,F,z.width,z.height):i.texImage2D(e.TEXTURE_2D,0,F,z.width,z.height,0,ce,ye,null));else if(M.isDataTexture)if(ue.length>0){me&&Te&&i.texStorage2D(e.TEXTURE_2D,Ve,F,ue[0].width,ue[0].height);for(let fe=0,Je=ue.length;fe<Je;fe++)Q=ue[fe],me?Ee&&i.texSubImage2D(e.TEXTURE_2D,fe,0,0,Q.width,Q.height,ce,ye,Q.data):i.texImage2D(e.TEXTURE_2D,fe,F,Q.width,Q.height,0,ce,ye,Q.data);M.generateMipmaps=!1}else me?(Te&&i.texStorage2D(e.TEXTURE_2D,Ve,F,z.width,z.height),Ee&&$e(M,z,ce,ye)):i.texImage2D(e.TEXTURE_2D,0,F,z.width,z.height,0,ce,ye,z.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){me&&Te&&i.texStorage3D(e.TEXTURE_2D_ARRAY,Ve,F,ue[0].width,ue[0].height,z.depth);for(let fe=0,Je=ue.length;fe<Je;fe++)if(Q=ue[fe],M.format!==zr)if(ce!==null)if(me){if(Ee)if(M.layerUpdates.size>0){let He=Kf(Q.width,Q.height,M.format,M.type);for(let Xe of M.layerUpdates){let Ae=Q.data.subarray(Xe*He/Q.data.BYTES_PER_ELEMENT,(Xe+1)*He/Q.data.BYTES_PER_ELEMENT);i.compressedTexSubImage3D(e.TEXTURE_2D_ARRAY,fe,0,0,Xe,Q.width,Q.height,1,ce,Ae)}}else i.compressedTexSubImage3D(e.TEXTURE_2D_ARRAY,fe,0,0,0,Q.width,Q.height,z.depth,ce,Q.data)}else i.compressedTexImage3D(e.TEXTURE_2D_ARRAY,fe,F,Q.width,Q.height,z.depth,0,Q.data,0,0);else Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else me?Ee&&i.texSubImage3D(e.TEXTURE_2D_ARRAY,fe,0,0,0,Q.width,Q.height,z.depth,ce,ye,Q.data):i.texImage3D(e.TEXTURE_2D_ARRAY,fe,F,Q.width,Q.height,z.depth,0,ce,ye,Q.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{me&&Te&&i.texStorage2D(e.TEXTURE_2D,Ve,F,ue[0].width,ue[0].height);for(let fe=0,Je=ue.length;fe<Je;fe++)Q=ue[fe],M.format!==zr?ce!==null?me?Ee&&i.compressedTexSubImage2D(e.TEXTURE_2D,fe,0,0,Q.width,Q.height,ce,Q.data):i.compressedTexImage2D(e.TEXTURE_2D,fe,F,Q.width,Q.height,0,Q.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):me?Ee&&i.texSubImage2D(e.TEXTURE_2D,fe,0,0,Q.width,Q.height,ce,ye,Q.data):i.texImage2D(e.TEXTURE_2D,fe,F,Q.width,Q.height,0,ce,ye,Q.data)}else if(M.isDataArrayTexture)if(me){if(Te&&i.texStorage3D(e.TEXTURE_2D_ARRAY,Ve,F,z.width,z.height,z.depth),Ee)if(M.layerUpdates.size>0){let fe=Kf(z.width,z.height,M.format,M.type);for(let Je of M.layerUpdates){let He=z.data.subarray(Je*fe/z.data.BYTES_PER_ELEMENT,(Je+1)*fe/z.data.BYTES_PER_ELEMENT);i.texSubImage3D(e.TEXTURE_2D_ARRAY,0,0,0,Je,z.width,z.height,1,ce,ye,He)}M.clearLayerUpdates()}else i.texSubImage3D(e.TEXTURE_2D_ARRAY,0,0,0,0,z.width,z.height,z.depth,ce,ye,z.data)}else i.texImage3D(e.TEXTURE_2D_ARRAY,0,F,z.width,z.height,z.depth,0,ce,ye,z.data);else if(M.isData3DTexture)me?(Te&&i.texStorage3D(e.TEXTURE_3D,Ve,F,z.width,z.height,z.depth),Ee&&i.texSubImage3D(e.TEXTURE_3D,0,0,0,0,z.width,z.height,z.depth,ce,ye,z.data)):i.texImage3D(e.TEXTURE_3D,0,F,z.width,z.height,z.depth,0,ce,ye,z.data);else if(M.isFramebufferTexture){if(Te)if(me)i.texStorage2D(e.TEXTURE_2D,Ve,F,z.width,z.height);else{let fe=z.width,Je=z.height;for(let He=0;He<Ve;He++)i.texImage2D(e.TEXTURE_2D,He,F,fe,Je,0,ce,ye,null),fe>>=1,Je>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in e){let fe=e.canvas;if(fe.hasAttribute("layoutsubtree")||fe.setAttribute("layoutsubtree","true"),z.parentNode!==fe){fe.appendChild(z),d.add(M),fe.onpaint=Je=>{let He=Je.changedElements;for(let Xe of d)He.includes(Xe.image)&&(Xe.needsUpdate=!0)},fe.requestPaint();return}if(e.texElementImage2D.length===3)e.texElementImage2D(e.TEXTURE_2D,e.RGBA8,z);else{let Je=e.RGBA,He=e.RGBA,Xe=e.UNSIGNED_BYTE;e.texElementImage2D(e.TEXTURE_2D,0,Je,He,Xe,z)}e.texParameteri(e.TEXTURE_2D,e.TEXTURE_MIN_FILTER,e.LINEAR),e.texParameteri(e.TEXTURE_2D,e.TEXTURE_WRAP_S,e.CLAMP_TO_EDGE),e.texParameteri(e.TEXTURE_2D,e.TEXTURE_WRAP_T,e.CLAMP_TO_EDGE)}}else if(ue.length>0){if(me&&Te){let fe=Ot(ue[0]);i.texStorage2D(e.TEXTURE_2D,Ve,F,fe.width,fe.height)}for(let fe=0,Je=ue.length;fe<Je;fe++)Q=ue[fe],me?Ee&&i.texSubImage2D(e.TEXTURE_2D,fe,0,0,ce,ye,Q):i.texImage2D(e.TEXTURE_2D,fe,F,ce,ye,Q);M.generateMipmaps=!1}else if(me){if(Te){let fe=Ot(z);i.texStorage2D(e.TEXTURE_2D,Ve,F,fe.width,fe.height)}Ee&&i.texSubImage2D(e.TEXTURE_2D,0,0,0,ce,ye,z)}else i.texImage2D(e.TEXTURE_2D,0,F,ce,ye,z);R(M)&&M.mipmapsAutoUpdate===!0&&E(he),Me.__version=xe.version,M.onUpdate&&M.onUpdate(M)}A.__version=M.version}function Nt(A,M,j){if(M.image.length!==6)return;let he=_t(A,M),ie=M.source;i.bindTexture(e.TEXTURE_CUBE_MAP,A.__webglTexture,e.TEXTURE0+j);let xe=r.get(ie);if(ie.version!==xe.__version||he===!0){i.activeTexture(e.TEXTURE0+j);let Me=ft.getPrimaries(ft.workingColorSpace),z=M.colorSpace===ba?null:ft.getPrimaries(M.colorSpace),ce=M.colorSpace===ba||Me===z?e.NONE:e.BROWSER_DEFAULT_WEBGL;i.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,M.flipY),i.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),i.pixelStorei(e.UNPACK_ALIGNMENT,M.unpackAlignment),i.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,ce);let ye=M.isCompressedTexture||M.image[0].isCompressedTexture,F=M.image[0]&&M.image[0].isDataTexture,Q=[];for(let Ae=0;Ae<6;Ae++)!ye&&!F?Q[Ae]=w(M.image[Ae],!0,a.maxCubemapSize):Q[Ae]=F?M.image[Ae].image:M.image[Ae],Q[Ae]=je(M,Q[Ae]);let ue=Q[0],me=n.convert(M.format,M.colorSpace),Te=n.convert(M.type),Ee=P(M.internalFormat,me,Te,M.normalized,M.colorSpace),Ve=M.isVideoTexture!==!0,fe=xe.__version===void 0||he===!0,Je=ie.dataReady,He=b(M,ue);at(e.TEXTURE_CUBE_MAP,M);let Xe;if(M.isDepthTexture){if(Ee=v(M.format===Ta,M.type),fe)if(Ve)i.texStorage2D(e.TEXTURE_CUBE_MAP,1,Ee,ue.width,ue.height);else for(let Ae=0;Ae<6;Ae++)i.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+Ae,0,Ee,ue.width,ue.height,0,me,Te,null)}else if(ye){Ve&&fe&&i.texStorage2D(e.TEXTURE_CUBE_MAP,He,Ee,ue.width,ue.height);for(let Ae=0;Ae<6;Ae++){Xe=Q[Ae].mipmaps;for(let yt=0;yt<Xe.length;yt++){let Et=Xe[yt];M.format!==zr?me!==null?Ve?Je&&i.compressedTexSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+Ae,yt,0,0,Et.width,Et.height,me,Et.data):i.compressedTexImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+Ae,yt,Ee,Et.width,Et.height,0,Et.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ve?Je&&i.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+Ae,yt,0,0,Et.width,Et.height,me,Te,Et.data):i.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+Ae,yt,Ee,Et.width,Et.height,0,me,Te,Et.data)}}}else{if(Xe=M.mipmaps,Ve&&fe){Xe.length>0&&He++;let Ae=Ot(Q[0]);i.texStorage2D(e.TEXTURE_CUBE_MAP,He,Ee,Ae.width,Ae.height)}for(let Ae=0;Ae<6;Ae++)if(F){Ve?Je&&i.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+Ae,0,0,0,Q[Ae].width,Q[Ae].height,me,Te,Q[Ae].data):i.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+Ae,0,Ee,Q[Ae].width,Q[Ae].height,0,me,Te,Q[Ae].data);for(let yt=0;yt<Xe.length;yt++){let Et=Xe[yt].image[Ae].image;Ve?Je&&i.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+Ae,yt+1,0,0,Et.width,Et.height,me,Te,Et.data):i.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+Ae,yt+1,Ee,Et.width,Et.height,0,me,Te,Et.data)}}else{Ve?Je&&i.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+Ae,0,0,0,me,Te,Q[Ae]):i.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+Ae,0,Ee,me,Te,Q[Ae]);for(let yt=0;yt<Xe.length;yt++){let Et=Xe[yt];Ve?Je&&i.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+Ae,yt+1,0,0,me,Te,Et.image[Ae]):i.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+Ae,yt+1,Ee,me,Te,Et.image[Ae])}}}R(M)&&M.mipmapsAutoUpdate===!0&&E(e.TEXTURE_CUBE_MAP),xe.__version=ie.version,M.onUpdate&&M.onUpdate(M)}A.__version=M.version}function vt(A,M,j,he,ie,xe){let Me=n.convert(j.format,j.colorSpace),z=n.convert(j.type),ce=P(j.internalFormat,Me,z,j.normalized,j.colorSpace),ye=r.get(M),F=r.get(j);if(F.__renderTarget=M,!ye.__hasExternalTextures){let Q=Math.max(1,M.width>>xe),ue=Math.max(1,M.height>>xe);ie===e.TEXTURE_3D||ie===e.TEXTURE_2D_ARRAY?i.texImage3D(ie,xe,ce,Q,ue,M.depth,0,Me,z,null):i.texImage2D(ie,xe,ce,Q,ue,0,Me,z,null)}i.bindFramebuffer(e.FRAMEBUFFER,A),Ke(M)?o.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,he,ie,F.__webglTexture,0,ae(M)):(ie===e.TEXTURE_2D||ie>=e.TEXTURE_CUBE_MAP_POSITIVE_X&&ie<=e.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&e.framebufferTexture2D(e.FRAMEBUFFER,he,ie,F.__webglTexture,xe),i.bindFramebuffer(e.FRAMEBUFFER,null)}function Zt(A,M,j){if(e.bindRenderbuffer(e.RENDERBUFFER,A),M.depthBuffer){let he=M.depthTexture,ie=he&&he.isDepthTexture?he.type:null,xe=v(M.stencilBuffer,ie),Me=M.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;Ke(M)?o.renderbufferStorageMultisampleEXT(e.RENDERBUFFER,ae(M),xe,M.width,M.height):j?e.renderbufferStorageMultisample(e.RENDERBUFFER,ae(M),xe,M.width,M.height):e.renderbufferStorage(e.RENDERBUFFER,xe,M.width,M.height),e.framebufferRenderbuffer(e.FRAMEBUFFER,Me,e.RENDERBUFFER,A)}else{let he=M.textures;for(let ie=0;ie<he.length;ie++){let xe=he[ie],Me=n.convert(xe.format,xe.colorSpace),z=n.convert(xe.type),ce=P(xe.internalFormat,Me,z,xe.normalized,xe.colorSpace);Ke(M)?o.renderbufferStorageMultisampleEXT(e.RENDERBUFFER,ae(M),ce,M.width,M.height):j?e.renderbufferStorageMultisample(e.RENDERBUFFER,ae(M),ce,M.width,M.height):e.renderbufferStorage(e.RENDERBUFFER,ce,M.width,M.height)}}e.bindRenderbuffer(e.RENDERBUFFER,null)}function mi(A,M,j){let he=M.isWebGLCubeRenderTarget===!0;if(i.bindFramebuffer(e.FRAMEBUFFER,A),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ie=r.get(M.depthTexture);ie.__renderTarget=M;let xe=he?M.depthTexture.image[0]:M.depthTexture.image;(!ie.__webglTexture||xe.width!==M.width||xe.height!==M.height)&&(xe.width=M.width,xe.height=M.height,M.depthTexture.needsUpdate=!0),he?le(M.depthTexture,0):se(M.depthTexture,0);let Me=ie.__webglTexture,z=ae(M),ce=he?e.TEXTURE_CUBE_MAP_POSITIVE_X+j:e.TEXTURE_2D,ye=M.depthTexture.format===Ta?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;if(M.depthTexture.format===Aa)Ke(M)?o.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,ye,ce,Me,0,z):e.framebufferTexture2D(e.FRAMEBUFFER,ye,ce,Me,0);else if(M.depthTexture.format===Ta)Ke(M)?o.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,ye,ce,Me,0,z):e.framebufferTexture2D(e.FRAMEBUFFER,ye,ce,Me,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Ut(A){let M=r.get(A),j=A.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==A.depthTexture){let he=A.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),he){let ie=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,he.removeEventListener("dispose",ie)};he.addEventListener("dispose",ie),M.__depthDisposeCallback=ie}M.__boundDepthTexture=he}if(A.depthTexture&&!M.__autoAllocateDepthBuffer)if(j)for(let he=0;he<6;he++)mi(M.__webglFramebuffer[he],A,he);else A.texture.mipmaps.length>0?mi(M.__webglFramebuffer[0],A,0):mi(M.__webglFramebuffer,A,0);else if(j){M.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(i.bindFramebuffer(e.FRAMEBUFFER,M.__webglFramebuffer[he]),M.__webglDepthbuffer[he]===void 0)M.__webglDepthbuffer[he]=e.createRenderbuffer(),Zt(M.__webglDepthbuffer[he],A,!1);else{let ie=A.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,xe=M.__webglDepthbuffer[he];e.bindRenderbuffer(e.RENDERBUFFER,xe),e.framebufferRenderbuffer(e.FRAMEBUFFER,ie,e.RENDERBUFFER,xe)}}else if(A.texture.mipmaps.length>0?i.bindFramebuffer(e.FRAMEBUFFER,M.__webglFramebuffer[0]):i.bindFramebuffer(e.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=e.createRenderbuffer(),Zt(M.__webglDepthbuffer,A,!1);else{let he=A.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,ie=M.__webglDepthbuffer;e.bindRenderbuffer(e.RENDERBUFFER,ie),e.framebufferRenderbuffer(e.FRAMEBUFFER,he,e.RENDERBUFFER,ie)}i.bindFramebuffer(e.FRAMEBUFFER,null)}function kt(A,M,j){let he=r.get(A);M!==void 0&&vt(he.__webglFramebuffer,A,A.texture,e.COLOR_ATTACHMENT0,e.TEXTURE_2D,0),j!==void 0&&Ut(A)}function V(A){let M=A.texture,j=r.get(A),he=r.get(M);A.addEventListener("dispose",B),U(A);let ie=A.textures,xe=A.isWebGLCubeRenderTarget===!0,Me=ie.length>1;if(Me||(he.__webglTexture===void 0&&(he.__webglTexture=e.createTexture()),he.__version=M.version,s.memory.textures++),xe){j.__webglFramebuffer=[];for(let z=0;z<6;z++)if(M.mipmaps.length>0){j.__webglFramebuffer[z]=[];for(let ce=0;ce<M.mipmaps.length;ce++)j.__webglFramebuffer[z][ce]=e.createFramebuffer()}else j.__webglFramebuffer[z]=e.createFramebuffer()}else{if(M.mipmaps.length>0){j.__webglFramebuffer=[];for(let z=0;z<M.mipmaps.length;z++)j.__webglFramebuffer[z]=e.createFramebuffer()}else j.__webglFramebuffer=e.createFramebuffer();if(Me)for(let z=0,ce=ie.length;z<ce;z++){let ye=r.get(ie[z]);ye.__webglTexture===void 0&&(ye.__webglTexture=e.createTexture(),s.memory.textures++)}if(A.samples>0&&Ke(A)===!1){j.__webglMultisampledFramebuffer=e.createFramebuffer(),j.__webglColorRenderbuffer=[],i.bindFramebuffer(e.FRAMEBUFFER,j.__webglMultisampledFramebuffer);for(let z=0;z<ie.length;z++){let ce=ie[z];j.__webglColorRenderbuffer[z]=e.createRenderbuffer(),e.bindRenderbuffer(e.RENDERBUFFER,j.__webglColorRenderbuffer[z]);let ye=n.convert(ce.format,ce.colorSpace),F=n.convert(ce.type),Q=P(ce.internalFormat,ye,F,ce.normalized,ce.colorSpace,A.isXRRenderTarget===!0),ue=ae(A);e.renderbufferStorageMultisample(e.RENDERBUFFER,ue,Q,A.width,A.height),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+z,e.RENDERBUFFER,j.__webglColorRenderbuffer[z])}e.bindRenderbuffer(e.RENDERBUFFER,null),A.depthBuffer&&(j.__webglDepthRenderbuffer=e.createRenderbuffer(),Zt(j.__webglDepthRenderbuffer,A,!0)),i.bindFramebuffer(e.FRAMEBUFFER,null)}}if(xe){i.bindTexture(e.TEXTURE_CUBE_MAP,he.__webglTexture),at(e.TEXTURE_CUBE_MAP,M);for(let z=0;z<6;z++)if(M.mipmaps.length>0)for(let ce=0;ce<M.mipmaps.length;ce++)vt(j.__webglFramebuffer[z][ce],A,M,e.COLOR_ATTACHMENT0,e.TEXTURE_CUBE_MAP_POSITIVE_X+z,ce);else vt(j.__webglFramebuffer[z],A,M,e.COLOR_ATTACHMENT0,e.TEXTURE_CUBE_MAP_POSITIVE_X+z,0);R(M)?E(e.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&e.texParameteri(e.TEXTURE_CUBE_MAP,e.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),i.unbindTexture()}else if(Me){for(let z=0,ce=ie.length;z<ce;z++){let ye=ie[z],F=r.get(ye),Q=e.TEXTURE_2D;(A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(Q=A.isWebGL3DRenderTarget?e.TEXTURE_3D:e.TEXTURE_2D_ARRAY),i.bindTexture(Q,F.__webglTexture),at(Q,ye),vt(j.__webglFramebuffer,A,ye,e.COLOR_ATTACHMENT0+z,Q,0),R(ye)&&E(Q)}i.unbindTexture()}else{let z=e.TEXTURE_2D;if((A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(z=A.isWebGL3DRenderTarget?e.TEXTURE_3D:e.TEXTURE_2D_ARRAY),i.bindTexture(z,he.__webglTexture),at(z,M),M.mipmaps.length>0)for(let ce=0;ce<M.mipmaps.length;ce++)vt(j.__webglFramebuffer[ce],A,M,e.COLOR_ATTACHMENT0,z,ce);else vt(j.__webglFramebuffer,A,M,e.COLOR_ATTACHMENT0,z,0);R(M)?E(z):M.mipmaps.length>0&&e.texParameteri(z,e.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),i.unbindTexture()}A.depthBuffer&&Ut(A)}function oi(A){let M=A.textures;for(let j=0,he=M.length;j<he;j++){let ie=M[j];if(R(ie)&&ie.mipmapsAutoUpdate===!0){let xe=T(A),Me=r.get(ie).__webglTexture;i.bindTexture(xe,Me),E(xe),i.unbindTexture()}}}let ht=[];function ve(A){if(A.samples>0){if(Ke(A)===!1){let M=A.textures,j=A.width,he=A.height,ie=e.COLOR_BUFFER_BIT,xe=A.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,Me=r.get(A),z=M.length>1;if(z)for(let ce=0;ce<M.length;ce++)i.bindFramebuffer(e.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+ce,e.RENDERBUFFER,null),i.bindFramebuffer(e.FRAMEBUFFER,Me.__webglFramebuffer),e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0+ce,e.TEXTURE_2D,null,0);i.bindFramebuffer(e.READ_FRAMEBUFFER,Me.__webglMultisampledFramebuffer),A.texture.mipmaps.length>0?i.bindFramebuffer(e.DRAW_FRAMEBUFFER,Me.__webglFramebuffer[0]):i.bindFramebuffer(e.DRAW_FRAMEBUFFER,Me.__webglFramebuffer);for(let ce=0;ce<M.length;ce++){if(A.resolveDepthBuffer&&(A.depthBuffer&&(ie|=e.DEPTH_BUFFER_BIT),A.stencilBuffer&&A.resolveStencilBuffer&&(ie|=e.STENCIL_BUFFER_BIT)),z){e.framebufferRenderbuffer(e.READ_FRAMEBUFFER,e.COLOR_ATTACHMENT0,e.RENDERBUFFER,Me.__webglColorRenderbuffer[ce]);let ye=r.get(M[ce]).__webglTexture;e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0,e.TEXTURE_2D,ye,0)}e.blitFramebuffer(0,0,j,he,0,0,j,he,ie,e.NEAREST),l===!0&&(ht.length=0,ht.push(e.COLOR_ATTACHMENT0+ce),A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&ht.push(xe),e.invalidateFramebuffer(e.READ_FRAMEBUFFER,ht))}if(i.bindFramebuffer(e.READ_FRAMEBUFFER,null),i.bindFramebuffer(e.DRAW_FRAMEBUFFER,null),z)for(let ce=0;ce<M.length;ce++){i.bindFramebuffer(e.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+ce,e.RENDERBUFFER,Me.__webglColorRenderbuffer[ce]);let ye=r.get(M[ce]).__webglTexture;i.bindFramebuffer(e.FRAMEBUFFER,Me.__webglFramebuffer),e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0+ce,e.TEXTURE_2D,ye,0)}i.bindFramebuffer(e.DRAW_FRAMEBUFFER,Me.__webglMultisampledFramebuffer)}else if(A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&l){let M=A.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;e.invalidateFramebuffer(e.DRAW_FRAMEBUFFER,[M])}}}function ae(A){return Math.min(a.maxSamples,A.samples)}function Ke(A){let M=r.get(A);return A.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Oe(A){let M=s.render.frame;c.get(A)!==M&&(c.set(A,M),A.update())}function je(A,M){let j=A.colorSpace,he=A.format,ie=A.type;return A.isCompressedTexture===!0||A.isVideoTexture===!0||j!==il&&j!==ba&&(ft.getTransfer(j)===Pt?(he!==zr||ie!==hr)&&Ye("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ze("WebGLTextures: Unsupported texture color space:",j)),M}function Ot(A){return typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement?(h.width=A.naturalWidth||A.width,h.height=A.naturalHeight||A.height):typeof VideoFrame<"u"&&A instanceof VideoFrame?(h.width=A.displayWidth,h.height=A.displayHeight):(h.width=A.width,h.height=A.height),h}this.allocateTextureUnit=K,this.resetTextureUnits=te,this.getTextureUnits=ne,this.setTextureUnits=Le,this.setTexture2D=se,this.setTexture2DArray=Ce,this.setTexture3D=Re,this.setTextureCube=le,this.rebindTextures=kt,this.setupRenderTarget=V,this.updateRenderTargetMipmap=oi,this.updateMultisampleRenderTarget=ve,this.setupDepthRenderbuffer=Ut,this.setupFrameBufferTexture=vt,this.useMultisampledRTT=Ke,this.dispose=G}function Xy(e,t){function i(r,a=ba){let n,s=ft.getTransfer(a);if(r===hr)return e.UNSIGNED_BYTE;if(r===kc)return e.UNSIGNED_SHORT_4_4_4_4;if(r===Bc)return e.UNSIGNED_SHORT_5_5_5_1;if(r===Ip)return e.UNSIGNED_INT_5_9_9_9_REV;if(r===Up)return e.UNSIGNED_INT_10F_11F_11F_REV;if(r===Dp)return e.BYTE;if(r===Np)return e.SHORT;if(r===Ns)return e.UNSIGNED_SHORT;if(r===Fc)return e.INT;if(r===Gr)return e.UNSIGNED_INT;if(r===Br)return e.FLOAT;if(r===Vr)return e.HALF_FLOAT;if(r===Op)return e.ALPHA;if(r===Fp)return e.RGB;if(r===zr)return e.RGBA;if(r===Aa)return e.DEPTH_COMPONENT;if(r===Ta)return e.DEPTH_STENCIL;if(r===kp)return e.RED;if(r===zc)return e.RED_INTEGER;if(r===Ja)return e.RG;if(r===Hc)return e.RG_INTEGER;if(r===Gc)return e.RGBA_INTEGER;if(r===jo||r===Xo||r===Yo||r===qo)if(s===Pt)if(n=t.get("WEBGL_compressed_texture_s3tc_srgb"),n!==null){if(r===jo)return n.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(r===Xo)return n.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(r===Yo)return n.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(r===qo)return n.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(n=t.get("WEBGL_compressed_texture_s3tc"),n!==null){if(r===jo)return n.COMPRESSED_RGB_S3TC_DXT1_EXT;if(r===Xo)return n.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(r===Yo)return n.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(r===qo)return n.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(r===rc||r===ac||r===nc||r===sc)if(n=t.get("WEBGL_compressed_texture_pvrtc"),n!==null){if(r===rc)return n.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(r===ac)return n.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(r===nc)return n.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(r===sc)return n.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(r===oc||r===lc||r===hc||r===cc||r===uc||r===Qo||r===dc)if(n=t.get("WEBGL_compressed_texture_etc"),n!==null){if(r===oc||r===lc)return s===Pt?n.COMPRESSED_SRGB8_ETC2:n.COMPRESSED_RGB8_ETC2;if(r===hc)return s===Pt?n.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:n.COMPRESSED_RGBA8_ETC2_EAC;if(r===cc)return n.COMPRESSED_R11_EAC;if(r===uc)return n.COMPRESSED_SIGNED_R11_EAC;if(r===Qo)return n.COMPRESSED_RG11_EAC;if(r===dc)return n.COMPRESSED_SIGNED_RG11_EAC}else return null;if(r===fc||r===pc||r===mc||r===gc||r===_c||r===vc||r===xc||r===Mc||r===Sc||r===yc||r===Ec||r===bc||r===wc||r===Tc)if(n=t.get("WEBGL_compressed_texture_astc"),n!==null){if(r===fc)return s===Pt?n.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:n.COMPRESSED_RGBA_ASTC_4x4_KHR;if(r===pc)return s===Pt?n.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:n.COMPRESSED_RGBA_ASTC_5x4_KHR;if(r===mc)return s===Pt?n.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:n.COMPRESSED_RGBA_ASTC_5x5_KHR;if(r===gc)return s===Pt?n.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:n.COMPRESSED_RGBA_ASTC_6x5_KHR;if(r===_c)return s===Pt?n.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:n.COMPRESSED_RGBA_ASTC_6x6_KHR;if(r===vc)return s===Pt?n.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:n.COMPRESSED_RGBA_ASTC_8x5_KHR;if(r===xc)return s===Pt?n.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:n.COMPRESSED_RGBA_ASTC_8x6_KHR;if(r===Mc)return s===Pt?n.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:n.COMPRESSED_RGBA_ASTC_8x8_KHR;if(r===Sc)return s===Pt?n.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:n.COMPRESSED_RGBA_ASTC_10x5_KHR;if(r===yc)return s===Pt?n.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:n.COMPRESSED_RGBA_ASTC_10x6_KHR;if(r===Ec)return s===Pt?n.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:n.COMPRESSED_RGBA_ASTC_10x8_KHR;if(r===bc)return s===Pt?n.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:n.COMPRESSED_RGBA_ASTC_10x10_KHR;if(r===wc)return s===Pt?n.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:n.COMPRESSED_RGBA_ASTC_12x10_KHR;if(r===Tc)return s===Pt?n.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:n.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(r===Ac||r===Rc||r===Cc)if(n=t.get("EXT_texture_compression_bptc"),n!==null){if(r===Ac)return s===Pt?n.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:n.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(r===Rc)return n.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(r===Cc)return n.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(r===Pc||r===Lc||r===el||r===Dc)if(n=t.get("EXT_texture_compression_rgtc"),n!==null){if(r===Pc)return n.COMPRESSED_RED_RGTC1_EXT;if(r===Lc)return n.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(r===el)return n.COMPRESSED_RED_GREEN_RGTC2_EXT;if(r===Dc)return n.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return r===jn?e.UNSIGNED_INT_24_8:e[r]!==void 0?e[r]:null}return{convert:i}}var Yy=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,qy=`
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

}`,$y=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new sm(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Bi({vertexShader:Yy,fragmentShader:qy,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Di(new lm(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Ky=class extends Ra{constructor(e,t){super();let i=this,r=null,a=1,n=null,s="local-floor",o=1,l=null,h=null,c=null,d=null,u=null,f=null,_=typeof XRWebGLBinding<"u",x=new $y,p={},m=t.getContextAttributes(),w=null,R=null,E=[],T=[],P=new rt,v=null,b=null,U=new lr;U.viewport=new Ft;let W=new lr;W.viewport=new Ft;let N=[U,W],B=new Zv,I=null,L=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(K){let re=E[K];return re===void 0&&(re=new Ch,E[K]=re),re.getTargetRaySpace()},this.getControllerGrip=function(K){let re=E[K];return re===void 0&&(re=new Ch,E[K]=re),re.getGripSpace()},this.getHand=function(K){let re=E[K];return re===void 0&&(re=new Ch,E[K]=re),re.getHandSpace()};function G(K){let re=T.indexOf(K.inputSource);if(re===-1)return;let se=E[re];se!==void 0&&(se.update(K.inputSource,K.frame,l||n),se.dispatchEvent({type:K.type,data:K.inputSource}))}function Z(){r.removeEventListener("select",G),r.removeEventListener("selectstart",G),r.removeEventListener("selectend",G),r.removeEventListener("squeeze",G),r.removeEventListener("squeezestart",G),r.removeEventListener("squeezeend",G),r.removeEventListener("end",Z),r.removeEventListener("inputsourceschange",O);for(let K=0;K<E.length;K++){let re=T[K];re!==null&&(T[K]=null,E[K].disconnect(re))}I=null,L=null,x.reset();for(let K in p)delete p[K];if(e.setRenderTarget(w),u=null,d=null,c=null,r=null,R=null,Le.stop(),i.isPresenting=!1,e.setPixelRatio(v),e.setSize(P.width,P.height,!1),b!==null){let K=b.camera;K.fov=b.fov,K.zoom=b.zoom,K.updateProjectionMatrix(),b=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(K){a=K,i.isPresenting===!0&&Ye("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(K){s=K,i.isPresenting===!0&&Ye("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||n},this.setReferenceSpace=function(K){l=K},this.getBaseLayer=function(){return d!==null?d:u},this.getBinding=function(){return c===null&&_&&(c=new XRWebGLBinding(r,t)),c},this.getFrame=function(){return f},this.getSession=function(){return r},this.setSession=async function(K){if(r=K,r!==null){if(w=e.getRenderTarget(),r.addEventListener("select",G),r.addEventListener("selectstart",G),r.addEventListener("selectend",G),r.addEventListener("squeeze",G),r.addEventListener("squeezestart",G),r.addEventListener("squeezeend",G),r.addEventListener("end",Z),r.addEventListener("inputsourceschange",O),m.xrCompatible!==!0&&await t.makeXRCompatible(),v=e.getPixelRatio(),e.getSize(P),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let re=null,se=null,Ce=null;m.depth&&(Ce=m.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,re=m.stencil?Ta:Aa,se=m.stencil?jn:Gr);let Re={colorFormat:t.RGBA8,depthFormat:Ce,scaleFactor:a};c=this.getBinding(),d=c.createProjectionLayer(Re),r.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),R=new Hr(d.textureWidth,d.textureHeight,{format:zr,type:hr,depthTexture:new Yn(d.textureWidth,d.textureHeight,se,void 0,void 0,void 0,void 0,void 0,void 0,re),stencilBuffer:m.stencil,colorSpace:e.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let re={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:a};u=new XRWebGLLayer(r,t,re),r.updateRenderState({baseLayer:u}),e.setPixelRatio(1),e.setSize(u.framebufferWidth,u.framebufferHeight,!1),R=new Hr(u.framebufferWidth,u.framebufferHeight,{format:zr,type:hr,colorSpace:e.outputColorSpace,stencilBuffer:m.stencil,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}R.isXRRenderTarget=!0,this.setFoveation(o),l=null,n=await r.requestReferenceSpace(s),Le.setContext(r),Le.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return x.getDepthTexture()};function O(K){for(let re=0;re<K.removed.length;re++){let se=K.removed[re],Ce=T.indexOf(se);Ce>=0&&(T[Ce]=null,E[Ce].disconnect(se))}for(let re=0;re<K.added.length;re++){let se=K.added[re],Ce=T.indexOf(se);if(Ce===-1){for(let le=0;le<E.length;le++)if(le>=T.length){T.push(se),Ce=le;break}else if(T[le]===null){T[le]=se,Ce=le;break}if(Ce===-1)break}let Re=E[Ce];Re&&Re.connect(se)}}function de(K,re){re===null?K.matrixWorld.copy(K.matrix):K.matrixWorld.multiplyMatrices(re.matrixWorld,K.matrix),K.matrixWorldInverse.copy(K.matrixWorld).invert()}this.updateCamera=function(K){if(r===null)return;let re=K.near,se=K.far;x.texture!==null&&(x.depthNear>0&&(re=x.depthNear),x.depthFar>0&&(se=x.depthFar)),B.near=W.near=U.near=re,B.far=W.far=U.far=se,(I!==B.near||L!==B.far)&&(r.updateRenderState({depthNear:B.near,depthFar:B.far}),I=B.near,L=B.far),B.layers.mask=K.layers.mask|6,U.layers.mask=B.layers.mask&-5,W.layers.mask=B.layers.mask&-3;let Ce=K.parent,Re=B.cameras;de(B,Ce);for(let le=0;le<Re.length;le++)de(Re[le],Ce);B.projectionMatrix.copy(U.projectionMatrix),B.projectionMatrixInverse.copy(U.projectionMatrixInverse),b===null&&K.isPerspectiveCamera&&(b={camera:K,fov:K.fov,zoom:K.zoom}),J(K,B,Ce)};function J(K,re,se){se===null?K.matrix.copy(re.matrixWorld):(K.matrix.copy(se.matrixWorld),K.matrix.invert(),K.matrix.multiply(re.matrixWorld)),K.matrix.decompose(K.position,K.quaternion,K.scale),K.updateMatrixWorld(!0),K.projectionMatrix.copy(re.projectionMatrix),K.projectionMatrixInverse.copy(re.projectionMatrixInverse),K.isPerspectiveCamera&&(K.fov=Is*2*Math.atan(1/K.projectionMatrix.elements[5]),K.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(d===null&&u===null))return o},this.setFoveation=function(K){o=K,d!==null&&(d.fixedFoveation=K),u!==null&&u.fixedFoveation!==void 0&&(u.fixedFoveation=K)},this.hasDepthSensing=function(){return x.texture!==null},this.getDepthSensingMesh=function(){return x.getMesh(B)},this.getCameraTexture=function(K){return p[K]};let te=null;function ne(K,re){if(h=re.getViewerPose(l||n),f=re,h!==null){let se=h.views;u!==null&&(e.setRenderTargetFramebuffer(R,u.framebuffer),e.setRenderTarget(R));let Ce=!1;se.length!==B.cameras.length&&(B.cameras.length=0,Ce=!0);for(let le=0;le<se.length;le++){let Fe=se[le],We=null;if(u!==null)We=u.getViewport(Fe);else{let at=c.getViewSubImage(d,Fe);We=at.viewport,le===0&&(e.setRenderTargetTextures(R,at.colorTexture,at.depthStencilTexture),e.setRenderTarget(R))}let we=N[le];we===void 0&&(we=new lr,we.layers.enable(le),we.viewport=new Ft,N[le]=we),we.matrix.fromArray(Fe.transform.matrix),we.matrix.decompose(we.position,we.quaternion,we.scale),we.projectionMatrix.fromArray(Fe.projectionMatrix),we.projectionMatrixInverse.copy(we.projectionMatrix).invert(),we.viewport.set(We.x,We.y,We.width,We.height),le===0&&(B.matrix.copy(we.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),Ce===!0&&B.cameras.push(we)}let Re=r.enabledFeatures;if(Re&&Re.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&_){c=i.getBinding();let le=c.getDepthInformation(se[0]);le&&le.isValid&&le.texture&&x.init(le,r.renderState)}if(Re&&Re.includes("camera-access")&&_){e.state.unbindTexture(),c=i.getBinding();for(let le=0;le<se.length;le++){let Fe=se[le].camera;if(Fe){let We=p[Fe];We||(We=new sm,p[Fe]=We);let we=c.getCameraImage(Fe);We.sourceTexture=we}}}}for(let se=0;se<E.length;se++){let Ce=T[se],Re=E[se];Ce!==null&&Re!==void 0&&Re.update(Ce,re,l||n)}te&&te(K,re),re.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:re}),f=null}let Le=new gm;Le.setAnimationLoop(ne),this.setAnimationLoop=function(K){te=K},this.dispose=function(){}}},Jy=new ti,Am=new et;Am.set(-1,0,0,0,1,0,0,0,1);function Zy(e,t){function i(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function r(p,m){m.color.getRGB(p.fogColor.value,cm(e)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function a(p,m,w,R,E){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?n(p,m):m.isMeshLambertMaterial?(n(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(n(p,m),d(p,m)):m.isMeshPhongMaterial?(n(p,m),c(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(n(p,m),u(p,m),m.isMeshPhysicalMaterial&&f(p,m,E)):m.isMeshMatcapMaterial?(n(p,m),_(p,m)):m.isMeshDepthMaterial?n(p,m):m.isMeshDistanceMaterial?(n(p,m),x(p,m)):m.isMeshNormalMaterial?n(p,m):m.isLineBasicMaterial?(s(p,m),m.isLineDashedMaterial&&o(p,m)):m.isPointsMaterial?l(p,m,w,R):m.isSpriteMaterial?h(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function n(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,i(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,i(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,i(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===Vi&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,i(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===Vi&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,i(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,i(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,i(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let w=t.get(m),R=w.envMap,E=w.envMapRotation;R&&(p.envMap.value=R,p.envMapRotation.value.setFromMatrix4(Jy.makeRotationFromEuler(E)).transpose(),R.isCubeTexture&&R.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Am),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,i(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,i(m.aoMap,p.aoMapTransform))}function s(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,i(m.map,p.mapTransform))}function o(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,w,R){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*w,p.scale.value=R*.5,m.map&&(p.map.value=m.map,i(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,i(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function h(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,i(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,i(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function d(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function u(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,i(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,i(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function f(p,m,w){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,i(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,i(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,i(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,i(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,i(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,i(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Vi&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,i(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,i(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=w.texture,p.transmissionSamplerSize.value.set(w.width,w.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,i(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,i(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,i(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,i(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,i(m.specularIntensityMap,p.specularIntensityMapTransform))}function _(p,m){m.matcap&&(p.matcap.value=m.matcap)}function x(p,m){let w=t.get(m).light;p.referencePosition.value.setFromMatrixPosition(w.matrixWorld),p.nearDistance.value=w.shadow.camera.near,p.farDistance.value=w.shadow.camera.far}return{refreshFogUniforms:r,refreshMaterialUniforms:a}}function Qy(e,t,i,r){let a={},n={};function s(w,R){let E=R.program;r.uniformBlockBinding(w,E,a[w.id])}function o(w,R){let E=a[w.id];E===void 0&&(_(w),E=l(w),a[w.id]=E,w.addEventListener("dispose",p));let T=R.program;r.updateUBOMapping(w,T);let P=t.render.frame;n[w.id]!==P&&(h(w),n[w.id]=P)}function l(w){let R=e.createBuffer(),E=w.__size,T=w.usage;return e.bindBuffer(e.UNIFORM_BUFFER,R),e.bufferData(e.UNIFORM_BUFFER,E,T),e.bindBuffer(e.UNIFORM_BUFFER,null),R}function h(w){let R=a[w.id],E=w.uniforms,T=w.__cache;e.bindBuffer(e.UNIFORM_BUFFER,R);for(let P=0,v=E.length;P<v;P++){let b=E[P];if(Array.isArray(b))for(let U=0,W=b.length;U<W;U++)c(b[U],P,U,T);else c(b,P,0,T)}e.bindBuffer(e.UNIFORM_BUFFER,null)}function c(w,R,E,T){if(u(w,R,E,T)===!0){let P=w.__offset,v=w.value;if(Array.isArray(v)){let b=0;for(let U=0;U<v.length;U++){let W=v[U],N=x(W,!0);d(W,w.__data,b),b+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else d(v,w.__data,0);e.bufferSubData(e.UNIFORM_BUFFER,P,w.__data)}}function d(w,R,E){typeof w=="number"||typeof w=="boolean"?R[E]=w:w.isMatrix3?(R[E]=w.elements[0],R[E+1]=w.elements[1],R[E+2]=w.elements[2],R[E+3]=0,R[E+4]=w.elements[3],R[E+5]=w.elements[4],R[E+6]=w.elements[5],R[E+7]=0,R[E+8]=w.elements[6],R[E+9]=w.elements[7],R[E+10]=w.elements[8],R[E+11]=0):ArrayBuffer.isView(w)?R.set(w.subarray(0,R.length-E),E):w.toArray(R,E)}function u(w,R,E,T){let P=w.value,v=R+"_"+E;if(Array.isArray(P)){T[v]===void 0&&(T[v]=[]);let b=T[v],U=!1;for(let W=0;W<P.length;W++)f(P[W],b,W)===!0&&(U=!0);return U}return f(P,T,v)}function f(w,R,E){if(R[E]===void 0)return typeof w=="number"||typeof w=="boolean"?R[E]=w:ArrayBuffer.isView(w)?R[E]=w.slice():R[E]=w.clone(),!0;{let T=R[E];if(typeof w=="number"||typeof w=="boolean"){if(T!==w)return R[E]=w,!0}else{if(ArrayBuffer.isView(w))return!0;if(T.equals(w)===!1)return T.copy(w),!0}}return!1}function _(w){let R=w.uniforms,E=0,T=16;for(let v=0,b=R.length;v<b;v++){let U=Array.isArray(R[v])?R[v]:[R[v]];for(let W=0,N=U.length;W<N;W++){let B=U[W],I=Array.isArray(B.value)?B.value:[B.value],L=Array.isArray(R[v])||Array.isArray(B.value),G=E;for(let O=0,de=I.length;O<de;O++){let J=I[O],te=x(J,L),ne=E%T,Le=ne%te.boundary,K=ne+Le;E+=Le,K!==0&&T-K<te.storage&&(E+=T-K),O===0&&(G=E),E+=te.storage}let Z=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new Z((E-G)/Float32Array.BYTES_PER_ELEMENT),B.__offset=G}}let P=E%T;return P>0&&(E+=T-P),w.__size=E,w.__cache={},this}function x(w,R){let E={boundary:0,storage:0};return typeof w=="number"||typeof w=="boolean"?(E.boundary=4,E.storage=4):w.isVector2?(E.boundary=8,E.storage=8):w.isVector3||w.isColor?(E.boundary=16,E.storage=12):w.isVector4?(E.boundary=16,E.storage=16):w.isMatrix3?(E.boundary=16,E.storage=48):w.isMatrix4?(E.boundary=16,E.storage=64):w.isTexture?Ye("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(w)?(E.boundary=16,E.storage=w.byteLength):Ye("WebGLRenderer: Unsupported uniform value type.",w),R===!0&&(E.boundary=16,E.storage=Math.ceil(E.storage/16)*16),E}function p(w){let R=w.target;R.removeEventListener("dispose",p),e.deleteBuffer(a[R.id]),delete a[R.id],delete n[R.id]}function m(){for(let w in a)e.deleteBuffer(a[w]);a={},n={}}return{bind:s,update:o,dispose:m}}var eE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Fr=null;function tE(){return Fr===null&&(Fr=new Yc(eE,16,16,Ja,Vr),Fr.name="DFG_LUT",Fr.minFilter=Gi,Fr.magFilter=Gi,Fr.wrapS=aa,Fr.wrapT=aa,Fr.generateMipmaps=!1,Fr.needsUpdate=!0),Fr}var Rm=class{constructor(e={}){let{canvas:t=z_(),context:i=null,depth:r=!0,stencil:a=!1,alpha:n=!1,antialias:s=!1,premultipliedAlpha:o=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:c=!1,reversedDepthBuffer:d=!1,outputBufferType:u=hr}=e;this.isWebGLRenderer=!0;let f;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");f=i.getContextAttributes().alpha}else f=n;let _=u,x=new Set([Gc,Hc,zc]),p=new Set([hr,Gr,Ns,jn,kc,Bc]),m=new Uint32Array(4),w=new Int32Array(4),R={textures:[],min:[],max:[],resolution:[]},E=null,T=null,P=[],v=[],b=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=na,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let U=this,W=!1,N=null,B=null,I=null,L=null;this._outputColorSpace=or;let G=0,Z=0,O=null,de=-1,J=null,te=new Ft,ne=new Ft,Le=null,K=new lt(0),re=0,se=t.width,Ce=t.height,Re=1,le=null,Fe=null,We=new Ft(0,0,se,Ce),we=new Ft(0,0,se,Ce),at=!1,_t=new sl,Mt=new Tv,$e=!1,St=!1,Nt=new ti,vt=new X,Zt=new Ft,mi={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ut=!1;function kt(){return O===null?Re:1}let V=i;function oi(y,k){return t.getContext(y,k)}let ht,ve,ae,Ke,Oe,je,Ot,A,M,j,he,ie,xe,Me,z,ce,ye,F,Q,ue,me,Te,Ee;try{let y={alpha:!0,depth:r,stencil:a,antialias:s,premultipliedAlpha:o,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:c};if("setAttribute"in t&&t.setAttribute("data-engine","three.js r187"),t.addEventListener("webglcontextlost",Je,!1),t.addEventListener("webglcontextrestored",He,!1),t.addEventListener("webglcontextcreationerror",Xe,!1),V===null){let k="webgl2";if(V=oi(k,y),V===null)throw oi(k)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ve()}catch(y){throw t.removeEventListener("webglcontextlost",Je,!1),t.removeEventListener("webglcontextrestored",He,!1),t.removeEventListener("webglcontextcreationerror",Xe,!1),Ze("WebGLRenderer: "+y.message),y}function Ve(){ht=new n1(V),ht.init(),me=new Xy(V,ht),ve=new qS(V,ht,e,me),ae=new Wy(V,ht),ve.reversedDepthBuffer&&d&&ae.buffers.depth.setReversed(!0),B=V.createFramebuffer(),I=V.createFramebuffer(),L=V.createFramebuffer(),Ke=new l1(V),Oe=new Py,je=new jy(V,ht,ae,Oe,ve,me,Ke),Ot=new a1(U),A=new cx(V),Te=new XS(V,A),M=new s1(V,A,Ke,Te),j=new c1(V,M,A,Te,Ke),F=new h1(V,ve,je),z=new $S(Oe),he=new Cy(U,Ot,ht,ve,Te,z),ie=new Zy(U,Oe),xe=new Dy,Me=new ky(ht),ye=new jS(U,Ot,ae,j,f,o),ce=new Vy(U,j,ve),Ee=new Qy(V,Ke,ve,ae),Q=new YS(V,ht,Ke),ue=new o1(V,ht,Ke),Ke.programs=he.programs,U.capabilities=ve,U.extensions=ht,U.properties=Oe,U.renderLists=xe,U.shadowMap=ce,U.state=ae,U.info=Ke}_!==hr&&(b=new d1(_,t.width,t.height,s,r,a));let fe=new Ky(U,V);this.xr=fe,this.getContext=function(){return V},this.getContextAttributes=function(){return V.getContextAttributes()},this.forceContextLoss=function(){let y=ht.get("WEBGL_lose_context");y&&y.loseContext()},this.forceContextRestore=function(){let y=ht.get("WEBGL_lose_context");y&&y.restoreContext()},this.getPixelRatio=function(){return Re},this.setPixelRatio=function(y){y!==void 0&&(Re=y,this.setSize(se,Ce,!1))},this.getSize=function(y){return y.set(se,Ce)},this.setSize=function(y,k,ee=!0){if(fe.isPresenting){Ye("WebGLRenderer: Can't change size while VR device is presenting.");return}se=y,Ce=k,t.width=Math.floor(y*Re),t.height=Math.floor(k*Re),ee===!0&&(t.style.width=y+"px",t.style.height=k+"px"),b!==null&&b.setSize(t.width,t.height),this.setViewport(0,0,y,k)},this.getDrawingBufferSize=function(y){return y.set(se*Re,Ce*Re).floor()},this.setDrawingBufferSize=function(y,k,ee){se=y,Ce=k,Re=ee,t.width=Math.floor(y*ee),t.height=Math.floor(k*ee),this.setViewport(0,0,y,k)},this.setEffects=function(y){if(_===hr){Ze("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(y){for(let k=0;k<y.length;k++)if(y[k].isOutputPass===!0){Ye("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}b.setEffects(y||[])},this.getCurrentViewport=function(y){return y.copy(te)},this.getViewport=function(y){return y.copy(We)},this.setViewport=function(y,k,ee,q){y.isVector4?We.set(y.x,y.y,y.z,y.w):We.set(y,k,ee,q),ae.viewport(te.copy(We).multiplyScalar(kt()).round())},this.getScissor=function(y){return y.copy(we)},this.setScissor=function(y,k,ee,q){y.isVector4?we.set(y.x,y.y,y.z,y.w):we.set(y,k,ee,q),ae.scissor(ne.copy(we).multiplyScalar(kt()).round())},this.getScissorTest=function(){return at},this.setScissorTest=function(y){ae.setScissorTest(at=y)},this.setOpaqueSort=function(y){le=y},this.setTransparentSort=function(y){Fe=y},this.getClearColor=function(y){return y.copy(ye.getClearColor())},this.setClearColor=function(){ye.setClearColor(...arguments)},this.getClearAlpha=function(){return ye.getClearAlpha()},this.setClearAlpha=function(){ye.setClearAlpha(...arguments)},this.clear=function(y=!0,k=!0,ee=!0){let q=0;if(y){let Y=!1;if(O!==null){let ge=O.texture.format;Y=x.has(ge)}if(Y){let ge=O.texture.type,be=p.has(ge),Se=ye.getClearColor(),De=ye.getClearAlpha(),Ue=Se.r,tt=Se.g,ct=Se.b;be?(m[0]=Ue,m[1]=tt,m[2]=ct,m[3]=De,V.clearBufferuiv(V.COLOR,0,m)):(w[0]=Ue,w[1]=tt,w[2]=ct,w[3]=De,V.clearBufferiv(V.COLOR,0,w))}else q|=V.COLOR_BUFFER_BIT}k&&(q|=V.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),ee&&(q|=V.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),q!==0&&V.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(y){y.setRenderer(this),N=y},this.dispose=function(){t.removeEventListener("webglcontextlost",Je,!1),t.removeEventListener("webglcontextrestored",He,!1),t.removeEventListener("webglcontextcreationerror",Xe,!1),ye.dispose(),xe.dispose(),Me.dispose(),je.dispose(),Oe.dispose(),Ot.dispose(),j.dispose(),M.dispose(),Te.dispose(),Ee.dispose(),he.dispose(),fe.dispose(),fe.removeEventListener("sessionstart",ts),fe.removeEventListener("sessionend",is),Xr.stop()};function Je(y){y.preventDefault(),Sf("WebGLRenderer: Context Lost."),W=!0}function He(){Sf("WebGLRenderer: Context Restored."),W=!1;let y=Ke.autoReset,k=ce.enabled,ee=ce.autoUpdate,q=ce.needsUpdate,Y=ce.type;Ve(),Ke.autoReset=y,ce.enabled=k,ce.autoUpdate=ee,ce.needsUpdate=q,ce.type=Y}function Xe(y){Ze("WebGLRenderer: A WebGL context could not be created. Reason: ",y.statusMessage)}function Ae(y){let k=y.target;k.removeEventListener("dispose",Ae),yt(k)}function yt(y){Et(y),Oe.remove(y)}function Et(y){let k=Oe.get(y).programs;k!==void 0&&(k.forEach(function(ee){he.releaseProgram(ee)}),y.isShaderMaterial&&he.releaseShaderCache(y))}this.renderBufferDirect=function(y,k,ee,q,Y,ge){k===null&&(k=mi);let be=Y.isMesh&&Y.matrixWorld.determinantAffine()<0,Se=Wi(y,k,ee,q,Y);ae.setMaterial(q,be);let De=ee.index,Ue=1;if(q.wireframe===!0){if(De=M.getWireframeAttribute(ee),De===void 0)return;Ue=2}let tt=ee.drawRange,ct=ee.attributes.position,ke=tt.start*Ue,gt=(tt.start+tt.count)*Ue;ge!==null&&(ke=Math.max(ke,ge.start*Ue),gt=Math.min(gt,(ge.start+ge.count)*Ue)),De!==null?(ke=Math.max(ke,0),gt=Math.min(gt,De.count)):ct!=null&&(ke=Math.max(ke,0),gt=Math.min(gt,ct.count));let Yt=gt-ke;if(Yt<0||Yt===1/0)return;Te.setup(Y,q,Se,ee,De);let Rt,Lt=Q;if(De!==null&&(Rt=A.get(De),Lt=ue,Lt.setIndex(Rt)),Y.isMesh)q.wireframe===!0?(ae.setLineWidth(q.wireframeLinewidth*kt()),Lt.setMode(V.LINES)):Lt.setMode(V.TRIANGLES);else if(Y.isLine){let Bt=q.linewidth;Bt===void 0&&(Bt=1),ae.setLineWidth(Bt*kt()),Y.isLineSegments?Lt.setMode(V.LINES):Y.isLineLoop?Lt.setMode(V.LINE_LOOP):Lt.setMode(V.LINE_STRIP)}else Y.isPoints?Lt.setMode(V.POINTS):Y.isSprite&&Lt.setMode(V.TRIANGLES);if(Y.isBatchedMesh)if(ht.get("WEBGL_multi_draw"))Lt.renderMultiDraw(Y._multiDrawStarts,Y._multiDrawCounts,Y._multiDrawCount);else{let Bt=Y._multiDrawStarts,ze=Y._multiDrawCounts,yi=Y._multiDrawCount,Rr=De?A.get(De).bytesPerElement:1,dr=Oe.get(q).currentProgram.getUniforms();for(let ei=0;ei<yi;ei++)dr.setValue(V,"_gl_DrawID",ei),Lt.render(Bt[ei]/Rr,ze[ei])}else if(Y.isInstancedMesh)Lt.renderInstances(ke,Yt,Y.count);else if(ee.isInstancedBufferGeometry){let Bt=ee._maxInstanceCount!==void 0?ee._maxInstanceCount:1/0,ze=Math.min(ee.instanceCount,Bt);Lt.renderInstances(ke,Yt,ze)}else Lt.render(ke,Yt)};function Ni(y,k,ee,q){N!==null&&y.isNodeMaterial&&N.setObject(q,y),$e===!0&&z.setState(y,ee,!1),y.transparent===!0&&y.side===ra&&y.forceSinglePass===!1?(y.side=Vi,y.needsUpdate=!0,jt(y,k,q),y.side=Ka,y.needsUpdate=!0,jt(y,k,q),y.side=ra):jt(y,k,q)}this.compile=function(y,k,ee=null){ee===null&&(ee=y),N!==null&&N.renderStart(y,k,ee),T=Me.get(ee),T.init(k),v.push(T),ee.traverseVisible(function(Y){Y.isLight&&Y.layers.test(k.layers)&&(T.pushLight(Y),Y.castShadow&&T.pushShadow(Y))}),y!==ee&&y.traverseVisible(function(Y){Y.isLight&&Y.layers.test(k.layers)&&(T.pushLight(Y),Y.castShadow&&T.pushShadow(Y))}),T.setupLights(),N!==null&&N.updateLights(T.state.lightsArray),St=this.localClippingEnabled,$e=z.init(this.clippingPlanes,St),$e===!0&&z.setGlobalState(this.clippingPlanes,k),N!==null&&ce.render(T.state.shadowsArray,ee,k);let q=new Set;return y.traverse(function(Y){if(!(Y.isMesh||Y.isPoints||Y.isLine||Y.isSprite))return;let ge=Y.material;if(ge)if(Array.isArray(ge))for(let be=0;be<ge.length;be++){let Se=ge[be];Ni(Se,ee,k,Y),q.add(Se)}else Ni(ge,ee,k,Y),q.add(ge)}),T=v.pop(),N!==null&&N.renderEnd(),q},this.compileAsync=function(y,k,ee=null){let q=this.compile(y,k,ee);return new Promise(Y=>{function ge(){if(q.forEach(function(be){let Se=Oe.get(be).currentProgram;(Se===void 0||Se.isReady())&&q.delete(be)}),q.size===0){Y(y);return}setTimeout(ge,10)}ht.get("KHR_parallel_shader_compile")!==null?ge():setTimeout(ge,10)})};let wr=null;function la(y){wr&&wr(y)}function ts(){Xr.stop()}function is(){Xr.start()}let Xr=new gm;Xr.setAnimationLoop(la),typeof self<"u"&&Xr.setContext(self),this.setAnimationLoop=function(y){wr=y,fe.setAnimationLoop(y),y===null?Xr.stop():Xr.start()},fe.addEventListener("sessionstart",ts),fe.addEventListener("sessionend",is),this.render=function(y,k){if(k!==void 0&&k.isCamera!==!0){Ze("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(W===!0)return;N!==null&&N.renderStart(y,k);let ee=fe.enabled===!0&&fe.isPresenting===!0,q=b!==null&&(O===null||ee)&&b.begin(U,O);if(y.matrixWorldAutoUpdate===!0&&y.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),fe.enabled===!0&&fe.isPresenting===!0&&(b===null||b.isCompositing()===!1)&&(fe.cameraAutoUpdate===!0&&fe.updateCamera(k),k=fe.getCamera()),y.isScene===!0&&y.onBeforeRender(U,y,k,O),T=Me.get(y,v.length),T.init(k),T.state.textureUnits=je.getTextureUnits(),v.push(T),Nt.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),k.isArrayCamera?Mt.setFromArrayCamera(k):_t.setFromProjectionMatrix(Nt,yr,k.reversedDepth),St=this.localClippingEnabled,$e=z.init(this.clippingPlanes,St),E=xe.get(y,P.length),E.init(),P.push(E),this.info.render.frame++,fe.enabled===!0&&fe.isPresenting===!0){let ge=U.xr.getDepthSensingMesh();ge!==null&&rs(ge,k,-1/0,U.sortObjects)}rs(y,k,0,U.sortObjects),E.finish(),N!==null&&N.updateLights(T.state.lightsArray),U.sortObjects===!0&&E.sort(le,Fe),Ut=fe.enabled===!1||fe.isPresenting===!1||fe.hasDepthSensing()===!1,Ut&&ye.addToRenderList(E,y),this.info.autoReset===!0&&this.info.reset(),$e===!0&&z.beginShadows();let Y=T.state.shadowsArray;if(ce.render(Y,y,k),$e===!0&&z.endShadows(),(q&&b.hasRenderPass())===!1){let ge=E.opaque,be=E.transmissive;if(T.setupLights(),k.isArrayCamera){let Se=k.cameras;if(be.length>0)for(let De=0,Ue=Se.length;De<Ue;De++){let tt=Se[De];js(ge,be,y,tt)}Ut&&ye.render(y);for(let De=0,Ue=Se.length;De<Ue;De++){let tt=Se[De];Tr(E,y,tt,tt.viewport)}}else be.length>0&&js(ge,be,y,k),Ut&&ye.render(y),Tr(E,y,k)}O!==null&&Z===0&&(je.updateMultisampleRenderTarget(O),je.updateRenderTargetMipmap(O)),q&&b.end(U),y.isScene===!0&&y.onAfterRender(U,y,k),Te.resetDefaultState(),de=-1,J=null,v.pop(),v.length>0?(T=v[v.length-1],je.setTextureUnits(T.state.textureUnits),$e===!0&&z.setGlobalState(U.clippingPlanes,T.state.camera)):T=null,P.pop(),P.length>0?E=P[P.length-1]:E=null,N!==null&&N.renderEnd()};function rs(y,k,ee,q){if(y.visible===!1)return;if(y.layers.test(k.layers)){if(y.isGroup)ee=y.renderOrder;else if(y.isLOD)y.autoUpdate===!0&&y.update(k);else if(y.isLight)T.pushLight(y),y.castShadow&&T.pushShadow(y);else if(y.isSprite){let ge=k.isArrayCamera?Mt:_t;if(!y.frustumCulled||y.intersectsFrustum(ge)){q&&Zt.setFromMatrixPosition(y.matrixWorld).applyMatrix4(Nt);let be=j.update(y),Se=y.material;Se.visible&&E.push(y,be,Se,ee,Zt.z,null,k)}}else if(y.isMesh||y.isLine||y.isPoints){let ge=k.isArrayCamera?Mt:_t;if(!y.frustumCulled||y.intersectsFrustum(ge)){let be=j.update(y),Se=y.material;if(q&&(y.boundingSphere!==void 0?(y.boundingSphere===null&&y.computeBoundingSphere(),Zt.copy(y.boundingSphere.center)):(be.boundingSphere===null&&be.computeBoundingSphere(),Zt.copy(be.boundingSphere.center)),Zt.applyMatrix4(y.matrixWorld).applyMatrix4(Nt)),Array.isArray(Se)){let De=be.groups;for(let Ue=0,tt=De.length;Ue<tt;Ue++){let ct=De[Ue],ke=Se[ct.materialIndex];ke&&ke.visible&&E.push(y,be,ke,ee,Zt.z,ct,k)}}else Se.visible&&E.push(y,be,Se,ee,Zt.z,null,k)}}}let Y=y.children;for(let ge=0,be=Y.length;ge<be;ge++)rs(Y[ge],k,ee,q)}function Tr(y,k,ee,q){let{opaque:Y,transmissive:ge,transparent:be}=y;T.setupLightsView(ee),$e===!0&&z.setGlobalState(U.clippingPlanes,ee),q&&ae.viewport(te.copy(q)),Y.length>0&&Ar(Y,k,ee),ge.length>0&&Ar(ge,k,ee),be.length>0&&Ar(be,k,ee),ae.buffers.depth.setTest(!0),ae.buffers.depth.setMask(!0),ae.buffers.color.setMask(!0),ae.setPolygonOffset(!1)}function js(y,k,ee,q){if((ee.isScene===!0?ee.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[q.id]===void 0){let ct=ht.has("EXT_color_buffer_half_float")||ht.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[q.id]=new Hr(1,1,{generateMipmaps:!0,type:ct?Vr:hr,minFilter:wa,samples:Math.max(4,ve.samples),stencilBuffer:a,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ft.workingColorSpace})}let Y=T.state.transmissionRenderTarget[q.id],ge=q.viewport||te;Y.setSize(ge.z*U.transmissionResolutionScale,ge.w*U.transmissionResolutionScale);let be=U.getRenderTarget(),Se=U.getActiveCubeFace(),De=U.getActiveMipmapLevel();U.setRenderTarget(Y),U.getClearColor(K),re=U.getClearAlpha(),re<1&&U.setClearColor(16777215,.5),U.clear(),Ut&&ye.render(ee);let Ue=U.toneMapping;U.toneMapping=na;let tt=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),T.setupLightsView(q),$e===!0&&z.setGlobalState(U.clippingPlanes,q),Ar(y,ee,q),je.updateMultisampleRenderTarget(Y),je.updateRenderTargetMipmap(Y),ht.has("WEBGL_multisampled_render_to_texture")===!1){let ct=!1;for(let ke=0,gt=k.length;ke<gt;ke++){let Yt=k[ke],{object:Rt,geometry:Lt,material:Bt,group:ze}=Yt;if(Bt.side===ra&&Rt.layers.test(q.layers)){let yi=Bt.side;Bt.side=Vi,Bt.needsUpdate=!0,as(Rt,ee,q,Lt,Bt,ze),Bt.side=yi,Bt.needsUpdate=!0,ct=!0}}ct===!0&&(je.updateMultisampleRenderTarget(Y),je.updateRenderTargetMipmap(Y))}U.setRenderTarget(be,Se,De),U.setClearColor(K,re),tt!==void 0&&(q.viewport=tt),U.toneMapping=Ue}function Ar(y,k,ee){let q=k.isScene===!0?k.overrideMaterial:null;for(let Y=0,ge=y.length;Y<ge;Y++){let be=y[Y],{object:Se,geometry:De,group:Ue}=be,tt=be.material;tt.allowOverride===!0&&q!==null&&(tt=q),Se.layers.test(ee.layers)&&as(Se,k,ee,De,tt,Ue)}}function as(y,k,ee,q,Y,ge){N!==null&&Y.isNodeMaterial&&N.setObject(y,Y),y.onBeforeRender(U,k,ee,q,Y,ge),y.modelViewMatrix.multiplyMatrices(ee.matrixWorldInverse,y.matrixWorld),y.normalMatrix.getNormalMatrix(y.modelViewMatrix),Y.onBeforeRender(U,k,ee,q,y,ge),Y.transparent===!0&&Y.side===ra&&Y.forceSinglePass===!1?(Y.side=Vi,Y.needsUpdate=!0,U.renderBufferDirect(ee,k,q,Y,y,ge),Y.side=Ka,Y.needsUpdate=!0,U.renderBufferDirect(ee,k,q,Y,y,ge),Y.side=ra):U.renderBufferDirect(ee,k,q,Y,y,ge),y.onAfterRender(U,k,ee,q,Y,ge)}function ur(y){let k=0;for(let ee of y)ee.texture!==null&&k++;return k}function jt(y,k,ee){k.isScene!==!0&&(k=mi);let q=Oe.get(y),Y=T.state.lights,ge=T.state.shadowsArray,be=Y.state.version,Se=he.getParameters(y,Y.state,ge,k,ee,T.state.lightProbeGridArray),De=he.getProgramCacheKey(Se),Ue=q.programs;q.environment=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?k.environment:null,q.fog=k.fog;let tt=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap;q.envMap=Ot.get(y.envMap||q.environment,tt),q.envMapRotation=q.environment!==null&&y.envMap===null?k.environmentRotation:y.envMapRotation,Ue===void 0&&(y.addEventListener("dispose",Ae),Ue=new Map,q.programs=Ue,q.programVariants=new Map);let ct=Ue.get(De);if(ct!==void 0){if(q.currentProgram===ct&&q.lightsStateVersion===be)return Da(y,Se),ct}else Se.uniforms=he.getUniforms(y),N!==null&&y.isNodeMaterial&&N.build(y,ee,Se),y.onBeforeCompile(Se,U),ct=he.acquireProgram(Se,De),Ue.set(De,ct),q.uniforms=Se.uniforms;let ke=q.uniforms;return(!y.isShaderMaterial&&!y.isRawShaderMaterial||y.clipping===!0)&&(ke.clippingPlanes=z.uniform),Da(y,Se),q.needsLights=Xs(y),q.lightsStateVersion=be,q.needsLights&&(ke.ambientLightColor.value=Y.state.ambient,ke.lightProbe.value=Y.state.probe,ke.sunLights.value=Y.state.sun,ke.sunLightShadows.value=Y.state.sunShadow,ke.directionalLights.value=Y.state.directional,ke.directionalLightShadows.value=Y.state.directionalShadow,ke.spotLights.value=Y.state.spot,ke.spotLightShadows.value=Y.state.spotShadow,ke.rectAreaLights.value=Y.state.rectArea,ke.ltc_1.value=Y.state.rectAreaLTC1,ke.ltc_2.value=Y.state.rectAreaLTC2,ke.pointLights.value=Y.state.point,ke.pointLightShadows.value=Y.state.pointShadow,ke.hemisphereLights.value=Y.state.hemi,ke.sunShadowMatrix.value=Y.state.sunShadowMatrix,ke.sunShadowCascade.value=Y.state.sunShadowCascade,ke.directionalShadowMatrix.value=Y.state.directionalShadowMatrix,ke.spotLightMatrix.value=Y.state.spotLightMatrix,ke.spotLightMap.value=Y.state.spotLightMap,ke.pointShadowMatrix.value=Y.state.pointShadowMatrix),q.numLightProbeGrids=ur(T.state.lightProbeGridArray),q.currentProgram=ct,q.uniformsList=null,ct}function Qt(y,k,ee,q,Y){let ge=Oe.get(y),be=ge.currentProgram.id+","+q+","+Y,Se=ge.programVariants.get(be);return Se===void 0?(Se=jt(y,k,ee),ge.programVariants.set(be,Se)):(ge.currentProgram=Se,ge.uniformsList=null,ge.outputColorSpace=q,ge.toneMapping=Y),Se}function Xt(y){if(y.uniformsList===null){let k=y.currentProgram.getUniforms();y.uniformsList=Zo.seqWithValue(k.seq,y.uniforms)}return y.uniformsList}function Da(y,k){let ee=Oe.get(y);ee.outputColorSpace=k.outputColorSpace,ee.batching=k.batching,ee.batchingColor=k.batchingColor,ee.instancing=k.instancing,ee.instancingColor=k.instancingColor,ee.instancingMorph=k.instancingMorph,ee.skinning=k.skinning,ee.morphTargets=k.morphTargets,ee.morphNormals=k.morphNormals,ee.morphColors=k.morphColors,ee.morphTargetsCount=k.morphTargetsCount,ee.numClippingPlanes=k.numClippingPlanes,ee.numIntersection=k.numClipIntersection,ee.vertexAlphas=k.vertexAlphas,ee.vertexTangents=k.vertexTangents,ee.toneMapping=k.toneMapping}function Wi(y,k,ee,q,Y){k.isScene!==!0&&(k=mi),je.resetTextureUnits();let ge=k.fog,be=q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial?k.environment:null,Se=O===null?U.outputColorSpace:O.isXRRenderTarget===!0?O.texture.colorSpace:ft.workingColorSpace,De=q.isMeshStandardMaterial||q.isMeshLambertMaterial&&!q.envMap||q.isMeshPhongMaterial&&!q.envMap,Ue=Ot.get(q.envMap||be,De),tt=q.vertexColors===!0&&!!ee.attributes.color&&ee.attributes.color.itemSize===4,ct=!!ee.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),ke=!!ee.morphAttributes.position,gt=!!ee.morphAttributes.normal,Yt=!!ee.morphAttributes.color,Rt=na;q.toneMapped&&(O===null||O.isXRRenderTarget===!0)&&(Rt=U.toneMapping);let Lt=ee.morphAttributes.position||ee.morphAttributes.normal||ee.morphAttributes.color,Bt=Lt!==void 0?Lt.length:0,ze=Oe.get(q),yi=T.state.lights;if($e===!0&&(St===!0||y!==J)){let xt=y===J&&q.id===de;z.setState(q,y,xt)}let Rr=!1,dr=!1;q.version===ze.__version?ze.needsLights&&ze.lightsStateVersion!==yi.state.version||Y.isBatchedMesh&&ze.batching===!1||!Y.isBatchedMesh&&ze.batching===!0||Y.isBatchedMesh&&ze.batchingColor===!0&&Y._colorsTexture===null||Y.isBatchedMesh&&ze.batchingColor===!1&&Y._colorsTexture!==null||Y.isInstancedMesh&&ze.instancing===!1||!Y.isInstancedMesh&&ze.instancing===!0||Y.isSkinnedMesh&&ze.skinning===!1||!Y.isSkinnedMesh&&ze.skinning===!0||Y.isInstancedMesh&&ze.instancingColor===!0&&Y.instanceColor===null||Y.isInstancedMesh&&ze.instancingColor===!1&&Y.instanceColor!==null||Y.isInstancedMesh&&ze.instancingMorph===!0&&Y.morphTexture===null||Y.isInstancedMesh&&ze.instancingMorph===!1&&Y.morphTexture!==null||ze.envMap!==Ue||q.fog===!0&&ze.fog!==ge||ze.numClippingPlanes!==void 0&&(ze.numClippingPlanes!==z.numPlanes||ze.numIntersection!==z.numIntersection)||ze.vertexAlphas!==tt||ze.vertexTangents!==ct||ze.morphTargets!==ke||ze.morphNormals!==gt||ze.morphColors!==Yt||ze.morphTargetsCount!==Bt||ze.numLightProbeGrids!==ur(T.state.lightProbeGridArray)?Rr=!0:(ze.outputColorSpace!==Se||ze.toneMapping!==Rt)&&(dr=!0):(Rr=!0,ze.__version=q.version);let ei=ze.currentProgram;(Rr===!0||dr===!0)&&(ei=dr===!0?Qt(q,k,Y,Se,Rt):jt(q,k,Y),N&&q.isNodeMaterial&&N.onUpdateProgram(q,ei,ze));let Yr=!1,Cr=!1,fr=!1,dt=ei.getUniforms(),li=ze.uniforms;if(ae.useProgram(ei.program)&&(Yr=!0,Cr=!0,fr=!0),q.id!==de&&(de=q.id,Cr=!0),Yr||J!==y){ae.buffers.depth.getReversed()&&y.reversedDepth!==!0&&(y._reversedDepth=!0,y.updateProjectionMatrix()),dt.setValue(V,"projectionMatrix",y.projectionMatrix),dt.setValue(V,"viewMatrix",y.matrixWorldInverse);let xt=dt.map.cameraPosition;xt!==void 0&&xt.setValue(V,vt.setFromMatrixPosition(y.matrixWorld)),ve.logarithmicDepthBuffer&&dt.setValue(V,"logDepthBufFC",2/(Math.log(y.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&dt.setValue(V,"isOrthographic",y.isOrthographicCamera===!0),J!==y&&(J=y,Cr=!0,fr=!0)}if(ze.needsLights&&(yi.state.sunShadowMap.length>0&&dt.setValue(V,"sunShadowMap",yi.state.sunShadowMap,je),yi.state.directionalShadowMap.length>0&&dt.setValue(V,"directionalShadowMap",yi.state.directionalShadowMap,je),yi.state.spotShadowMap.length>0&&dt.setValue(V,"spotShadowMap",yi.state.spotShadowMap,je),yi.state.pointShadowMap.length>0&&dt.setValue(V,"pointShadowMap",yi.state.pointShadowMap,je)),Y.isSkinnedMesh){dt.setOptional(V,Y,"bindMatrix"),dt.setOptional(V,Y,"bindMatrixInverse");let xt=Y.skeleton;xt&&(xt.boneTexture===null&&xt.computeBoneTexture(),dt.setValue(V,"boneTexture",xt.boneTexture,je))}Y.isBatchedMesh&&(dt.setOptional(V,Y,"batchingTexture"),dt.setValue(V,"batchingTexture",Y._matricesTexture,je),dt.setOptional(V,Y,"batchingIdTexture"),dt.setValue(V,"batchingIdTexture",Y._indirectTexture,je),dt.setOptional(V,Y,"batchingColorTexture"),Y._colorsTexture!==null&&dt.setValue(V,"batchingColorTexture",Y._colorsTexture,je));let ji=ee.morphAttributes;if((ji.position!==void 0||ji.normal!==void 0||ji.color!==void 0)&&F.update(Y,ee,ei),(Cr||ze.receiveShadow!==Y.receiveShadow)&&(ze.receiveShadow=Y.receiveShadow,dt.setValue(V,"receiveShadow",Y.receiveShadow)),(q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial)&&q.envMap===null&&k.environment!==null&&(li.envMapIntensity.value=k.environmentIntensity),li.dfgLUT!==void 0&&(li.dfgLUT.value=tE()),Cr){if(dt.setValue(V,"toneMappingExposure",U.toneMappingExposure),ze.needsLights&&Na(li,fr),ge&&q.fog===!0&&ie.refreshFogUniforms(li,ge),ie.refreshMaterialUniforms(li,q,Re,Ce,T.state.transmissionRenderTarget[y.id]),ze.needsLights&&ze.numLightProbeGrids>0){let xt=R,ri=0;for(let Xi of T.state.lightProbeGridArray)Xi.texture!==null&&(xt.textures[ri]=Xi.texture,xt.min[ri]=Xi.boundingBox.min,xt.max[ri]=Xi.boundingBox.max,xt.resolution[ri]=Xi.resolution,ri++);for(let Xi in xt)xt[Xi].length=ri;li.probesSH.value=xt.textures,li.probesMin.value=xt.min,li.probesMax.value=xt.max,li.probesResolution.value=xt.resolution}Zo.upload(V,Xt(ze),li,je)}if(q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(Zo.upload(V,Xt(ze),li,je),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&dt.setValue(V,"center",Y.center),dt.setValue(V,"modelViewMatrix",Y.modelViewMatrix),dt.setValue(V,"normalMatrix",Y.normalMatrix),dt.setValue(V,"modelMatrix",Y.matrixWorld),q.uniformsGroups!==void 0){let xt=q.uniformsGroups;for(let ri=0,Xi=xt.length;ri<Xi;ri++){let ha=xt[ri];Ee.update(ha,ei),Ee.bind(ha,ei)}}return ei}function Na(y,k){y.ambientLightColor.needsUpdate=k,y.lightProbe.needsUpdate=k,y.sunLights.needsUpdate=k,y.sunLightShadows.needsUpdate=k,y.directionalLights.needsUpdate=k,y.directionalLightShadows.needsUpdate=k,y.pointLights.needsUpdate=k,y.pointLightShadows.needsUpdate=k,y.spotLights.needsUpdate=k,y.spotLightShadows.needsUpdate=k,y.rectAreaLights.needsUpdate=k,y.hemisphereLights.needsUpdate=k}function Xs(y){return y.isMeshLambertMaterial||y.isMeshToonMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isShadowMaterial||y.isShaderMaterial&&y.lights===!0}this.getActiveCubeFace=function(){return G},this.getActiveMipmapLevel=function(){return Z},this.getRenderTarget=function(){return O},this.setRenderTargetTextures=function(y,k,ee){let q=Oe.get(y);q.__autoAllocateDepthBuffer=y.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),Oe.get(y.texture).__webglTexture=k,Oe.get(y.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:ee,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(y,k){let ee=Oe.get(y);ee.__webglFramebuffer=k,ee.__useDefaultFramebuffer=k===void 0},this.setRenderTarget=function(y,k=0,ee=0){O=y,G=k,Z=ee;let q=null,Y=!1,ge=!1;if(y){let be=Oe.get(y);if(be.__useDefaultFramebuffer!==void 0){ae.bindFramebuffer(V.FRAMEBUFFER,be.__webglFramebuffer),te.copy(y.viewport),ne.copy(y.scissor),Le=y.scissorTest,ae.viewport(te),ae.scissor(ne),ae.setScissorTest(Le),de=-1;return}else if(be.__webglFramebuffer===void 0)je.setupRenderTarget(y);else if(be.__hasExternalTextures)je.rebindTextures(y,Oe.get(y.texture).__webglTexture,Oe.get(y.depthTexture).__webglTexture);else if(y.depthBuffer){let Ue=y.depthTexture;if(be.__boundDepthTexture!==Ue){if(Ue!==null&&Oe.has(Ue)&&(y.width!==Ue.image.width||y.height!==Ue.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");je.setupDepthRenderbuffer(y)}}let Se=y.texture;(Se.isData3DTexture||Se.isDataArrayTexture||Se.isCompressedArrayTexture)&&(ge=!0);let De=Oe.get(y).__webglFramebuffer;y.isWebGLCubeRenderTarget?(Array.isArray(De[k])?q=De[k][ee]:q=De[k],Y=!0):y.samples>0&&je.useMultisampledRTT(y)===!1?q=Oe.get(y).__webglMultisampledFramebuffer:Array.isArray(De)?q=De[ee]:q=De,te.copy(y.viewport),ne.copy(y.scissor),Le=y.scissorTest}else te.copy(We).multiplyScalar(Re).floor(),ne.copy(we).multiplyScalar(Re).floor(),Le=at;if(ee!==0&&(q=B),ae.bindFramebuffer(V.FRAMEBUFFER,q)&&ae.drawBuffers(y,q),ae.viewport(te),ae.scissor(ne),ae.setScissorTest(Le),Y){let be=Oe.get(y.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_CUBE_MAP_POSITIVE_X+k,be.__webglTexture,ee)}else if(ge){let be=k;for(let Se=0;Se<y.textures.length;Se++){let De=Oe.get(y.textures[Se]);V.framebufferTextureLayer(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0+Se,De.__webglTexture,ee,be)}}else if(y!==null&&ee!==0){let be=Oe.get(y.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,be.__webglTexture,ee)}de=-1};function nn(y){let k=Oe.get(y);return(k.__readFormat!==y.format||k.__readType!==y.type)&&(k.__readFormat=y.format,k.__readType=y.type,k.__formatReadable=ve.textureFormatReadable(y.format),k.__typeReadable=ve.textureTypeReadable(y.type)),k}this.readRenderTargetPixels=function(y,k,ee,q,Y,ge,be,Se=0){if(!(y&&y.isWebGLRenderTarget)){Ze("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=Oe.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&be!==void 0&&(De=De[be],Array.isArray(De)&&(De=De[0])),De){ae.bindFramebuffer(V.FRAMEBUFFER,De);try{let Ue=y.textures[Se],tt=Ue.format,ct=Ue.type;y.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Se);let ke=nn(Ue);if(ke.__formatReadable===!1){Ze("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ke.__typeReadable===!1){Ze("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=y.width-q&&ee>=0&&ee<=y.height-Y&&V.readPixels(k,ee,q,Y,me.convert(tt),me.convert(ct),ge)}finally{let Ue=O!==null?Oe.get(O).__webglFramebuffer:null;ae.bindFramebuffer(V.FRAMEBUFFER,Ue)}}},this.readRenderTargetPixelsAsync=async function(y,k,ee,q,Y,ge,be,Se=0){if(!(y&&y.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=Oe.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&be!==void 0&&(De=De[be],Array.isArray(De)&&(De=De[0])),De)if(k>=0&&k<=y.width-q&&ee>=0&&ee<=y.height-Y){ae.bindFramebuffer(V.FRAMEBUFFER,De);let Ue=y.textures[Se],tt=Ue.format,ct=Ue.type;y.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Se);let ke=nn(Ue);if(ke.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ke.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let gt=V.createBuffer();V.bindBuffer(V.PIXEL_PACK_BUFFER,gt),V.bufferData(V.PIXEL_PACK_BUFFER,ge.byteLength,V.STREAM_READ),V.readPixels(k,ee,q,Y,me.convert(tt),me.convert(ct),0),V.bindBuffer(V.PIXEL_PACK_BUFFER,null);let Yt=O!==null?Oe.get(O).__webglFramebuffer:null;ae.bindFramebuffer(V.FRAMEBUFFER,Yt);let Rt=V.fenceSync(V.SYNC_GPU_COMMANDS_COMPLETE,0);return V.flush(),await H_(V,Rt,4),V.bindBuffer(V.PIXEL_PACK_BUFFER,gt),V.getBufferSubData(V.PIXEL_PACK_BUFFER,0,ge),V.bindBuffer(V.PIXEL_PACK_BUFFER,null),V.deleteBuffer(gt),V.deleteSync(Rt),ge}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(y,k=null,ee=0){let q=Math.pow(2,-ee),Y=Math.floor(y.image.width*q),ge=Math.floor(y.image.height*q),be=k!==null?k.x:0,Se=k!==null?k.y:0;je.setTexture2D(y,0),V.copyTexSubImage2D(V.TEXTURE_2D,ee,0,0,be,Se,Y,ge),ae.unbindTexture()},this.copyTextureToTexture=function(y,k,ee=null,q=null,Y=0,ge=0){let be,Se,De,Ue,tt,ct,ke,gt,Yt,Rt=y.isCompressedTexture?y.mipmaps[ge]:y.image;if(ee!==null)be=ee.max.x-ee.min.x,Se=ee.max.y-ee.min.y,De=ee.isBox3?ee.max.z-ee.min.z:1,Ue=ee.min.x,tt=ee.min.y,ct=ee.isBox3?ee.min.z:0;else{let dt=Math.pow(2,-Y);be=Math.floor(Rt.width*dt),Se=Math.floor(Rt.height*dt),y.isDataArrayTexture?De=Rt.depth:y.isData3DTexture?De=Math.floor(Rt.depth*dt):De=1,Ue=0,tt=0,ct=0}q!==null?(ke=q.x,gt=q.y,Yt=q.z):(ke=0,gt=0,Yt=0);let Lt=me.convert(k.format),Bt=me.convert(k.type),ze;k.isData3DTexture?(je.setTexture3D(k,0),ze=V.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(je.setTexture2DArray(k,0),ze=V.TEXTURE_2D_ARRAY):(je.setTexture2D(k,0),ze=V.TEXTURE_2D),ae.activeTexture(V.TEXTURE0),ae.pixelStorei(V.UNPACK_FLIP_Y_WEBGL,k.flipY),ae.pixelStorei(V.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),ae.pixelStorei(V.UNPACK_ALIGNMENT,k.unpackAlignment);let yi=ae.getParameter(V.UNPACK_ROW_LENGTH),Rr=ae.getParameter(V.UNPACK_IMAGE_HEIGHT),dr=ae.getParameter(V.UNPACK_SKIP_PIXELS),ei=ae.getParameter(V.UNPACK_SKIP_ROWS),Yr=ae.getParameter(V.UNPACK_SKIP_IMAGES);ae.pixelStorei(V.UNPACK_ROW_LENGTH,Rt.width),ae.pixelStorei(V.UNPACK_IMAGE_HEIGHT,Rt.height),ae.pixelStorei(V.UNPACK_SKIP_PIXELS,Ue),ae.pixelStorei(V.UNPACK_SKIP_ROWS,tt),ae.pixelStorei(V.UNPACK_SKIP_IMAGES,ct);let Cr=y.isDataArrayTexture||y.isData3DTexture,fr=k.isDataArrayTexture||k.isData3DTexture;if(y.isDepthTexture){let dt=Oe.get(y),li=Oe.get(k),ji=Oe.get(dt.__renderTarget),xt=Oe.get(li.__renderTarget);ae.bindFramebuffer(V.READ_FRAMEBUFFER,ji.__webglFramebuffer),ae.bindFramebuffer(V.DRAW_FRAMEBUFFER,xt.__webglFramebuffer);for(let ri=0;ri<De;ri++)Cr&&(V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Oe.get(y).__webglTexture,Y,ct+ri),V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Oe.get(k).__webglTexture,ge,Yt+ri)),V.blitFramebuffer(Ue,tt,Ue+be,tt+Se,ke,gt,ke+be,gt+Se,V.DEPTH_BUFFER_BIT,V.NEAREST);ae.bindFramebuffer(V.READ_FRAMEBUFFER,null),ae.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else if(Y!==0||y.isRenderTargetTexture||Oe.has(y)){let dt=Oe.get(y),li=Oe.get(k);ae.bindFramebuffer(V.READ_FRAMEBUFFER,I),ae.bindFramebuffer(V.DRAW_FRAMEBUFFER,L);for(let ji=0;ji<De;ji++)Cr?V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,dt.__webglTexture,Y,ct+ji):V.framebufferTexture2D(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,dt.__webglTexture,Y),fr?V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,li.__webglTexture,ge,Yt+ji):V.framebufferTexture2D(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,li.__webglTexture,ge),Y!==0?V.blitFramebuffer(Ue,tt,Ue+be,tt+Se,ke,gt,ke+be,gt+Se,V.COLOR_BUFFER_BIT,V.NEAREST):fr?V.copyTexSubImage3D(ze,ge,ke,gt,Yt+ji,Ue,tt,be,Se):V.copyTexSubImage2D(ze,ge,ke,gt,Ue,tt,be,Se);ae.bindFramebuffer(V.READ_FRAMEBUFFER,null),ae.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else fr?y.isDataTexture||y.isData3DTexture?V.texSubImage3D(ze,ge,ke,gt,Yt,be,Se,De,Lt,Bt,Rt.data):k.isCompressedArrayTexture?V.compressedTexSubImage3D(ze,ge,ke,gt,Yt,be,Se,De,Lt,Rt.data):V.texSubImage3D(ze,ge,ke,gt,Yt,be,Se,De,Lt,Bt,Rt):y.isDataTexture?V.texSubImage2D(V.TEXTURE_2D,ge,ke,gt,be,Se,Lt,Bt,Rt.data):y.isCompressedTexture?V.compressedTexSubImage2D(V.TEXTURE_2D,ge,ke,gt,Rt.width,Rt.height,Lt,Rt.data):V.texSubImage2D(V.TEXTURE_2D,ge,ke,gt,be,Se,Lt,Bt,Rt);ae.pixelStorei(V.UNPACK_ROW_LENGTH,yi),ae.pixelStorei(V.UNPACK_IMAGE_HEIGHT,Rr),ae.pixelStorei(V.UNPACK_SKIP_PIXELS,dr),ae.pixelStorei(V.UNPACK_SKIP_ROWS,ei),ae.pixelStorei(V.UNPACK_SKIP_IMAGES,Yr),ge===0&&k.generateMipmaps===!0&&k.mipmapsAutoUpdate===!0&&V.generateMipmap(ze),ae.unbindTexture()},this.initRenderTarget=function(y){Oe.get(y).__webglFramebuffer===void 0&&je.setupRenderTarget(y)},this.initTexture=function(y){y.isCubeTexture?je.setTextureCube(y,0):y.isData3DTexture?je.setTexture3D(y,0):y.isDataArrayTexture||y.isCompressedArrayTexture?je.setTexture2DArray(y,0):je.setTexture2D(y,0),ae.unbindTexture()},this.resetState=function(){G=0,Z=0,O=null,ae.reset(),Te.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return yr}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=ft._getDrawingBufferColorSpace(e),t.unpackColorSpace=ft._getUnpackColorSpace()}},xp={type:"change"},Zc={type:"start"},Cm={type:"end"},Vo=new hl,Mp=new ia,iE=Math.cos(70*av.DEG2RAD),ui=new X,Hi=2*Math.PI,Tt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Yh=1e-6,Qc=class extends lx{constructor(e,t=null){super(e,t),this.state=Tt.NONE,this.target=new X,this.cursor=new X,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Hn.ROTATE,MIDDLE:Hn.DOLLY,RIGHT:Hn.PAN},this.touches={ONE:zn.ROTATE,TWO:zn.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new X,this._lastQuaternion=new Er,this._lastTargetPosition=new X,this._quat=new Er().setFromUnitVectors(e.up,new X(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new $f,this._sphericalDelta=new $f,this._scale=1,this._panOffset=new X,this._rotateStart=new rt,this._rotateEnd=new rt,this._rotateDelta=new rt,this._panStart=new rt,this._panEnd=new rt,this._panDelta=new rt,this._dollyStart=new rt,this._dollyEnd=new rt,this._dollyDelta=new rt,this._dollyDirection=new X,this._mouse=new rt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=aE.bind(this),this._onPointerDown=rE.bind(this),this._onPointerUp=nE.bind(this),this._onContextMenu=dE.bind(this),this._onMouseWheel=lE.bind(this),this._onKeyDown=hE.bind(this),this._onTouchStart=cE.bind(this),this._onTouchMove=uE.bind(this),this._onMouseDown=sE.bind(this),this._onMouseMove=oE.bind(this),this._interceptControlDown=fE.bind(this),this._interceptControlUp=pE.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Tt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(xp),this.update(),this.state=Tt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;ui.copy(t).sub(this.target),ui.applyQuaternion(this._quat),this._spherical.setFromVector3(ui),this.autoRotate&&this.state===Tt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,r=this.maxAzimuthAngle;isFinite(i)&&isFinite(r)&&(i<-Math.PI?i+=Hi:i>Math.PI&&(i-=Hi),r<-Math.PI?r+=Hi:r>Math.PI&&(r-=Hi),i<=r?this._spherical.theta=Math.max(i,Math.min(r,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+r)/2?Math.max(i,this._spherical.theta):Math.min(r,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let a=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let n=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),a=n!=this._spherical.radius}if(ui.setFromSpherical(this._spherical),ui.applyQuaternion(this._quatInverse),t.copy(this.target).add(ui),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let n=null;if(this.object.isPerspectiveCamera){let s=ui.length();n=this._clampDistance(s*this._scale);let o=s-n;this.object.position.addScaledVector(this._dollyDirection,o),this.object.updateMatrixWorld(),a=!!o}else if(this.object.isOrthographicCamera){let s=new X(this._mouse.x,this._mouse.y,0);s.unproject(this.object);let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),a=o!==this.object.zoom;let l=new X(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(s),this.object.updateMatrixWorld(),n=ui.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;n!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(n).add(this.object.position):(Vo.origin.copy(this.object.position),Vo.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Vo.direction))<iE?this.object.lookAt(this.target):(Mp.setFromNormalAndCoplanarPoint(this.object.up,this.target),Vo.intersectPlane(Mp,this.target))))}else if(this.object.isOrthographicCamera){let n=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),n!==this.object.zoom&&(this.object.updateProjectionMatrix(),a=!0)}return this._scale=1,this._performCursorZoom=!1,a||this._lastPosition.distanceToSquared(this.object.position)>Yh||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Yh||this._lastTargetPosition.distanceToSquared(this.target)>Yh?(this.dispatchEvent(xp),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Hi/60*this.autoRotateSpeed*e:Hi/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){ui.setFromMatrixColumn(t,0),ui.multiplyScalar(-e),this._panOffset.add(ui)}_panUp(e,t){this.screenSpacePanning===!0?ui.setFromMatrixColumn(t,1):(ui.setFromMatrixColumn(t,0),ui.crossVectors(this.object.up,ui)),ui.multiplyScalar(e),this._panOffset.add(ui)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let r=this.object.position;ui.copy(r).sub(this.target);let a=ui.length();a*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*a/i.clientHeight,this.object.matrix),this._panUp(2*t*a/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),r=e-i.left,a=t-i.top,n=i.width,s=i.height;this._mouse.x=r/n*2-1,this._mouse.y=-(a/s)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Hi*this._rotateDelta.x/t.clientHeight),this._rotateUp(Hi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._rotateStart.set(i,r)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._panStart.set(i,r)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,r=e.pageY-t.y,a=Math.sqrt(i*i+r*r);this._dollyStart.set(0,a)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),r=.5*(e.pageX+i.x),a=.5*(e.pageY+i.y);this._rotateEnd.set(r,a)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Hi*this._rotateDelta.x/t.clientHeight),this._rotateUp(Hi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._panEnd.set(i,r)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,r=e.pageY-t.y,a=Math.sqrt(i*i+r*r);this._dollyEnd.set(0,a),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let n=(e.pageX+t.x)*.5,s=(e.pageY+t.y)*.5;this._updateZoomParameters(n,s)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new rt,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function rE(e){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(e.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(e)&&(this._addPointer(e),e.pointerType==="touch"?this._onTouchStart(e):this._onMouseDown(e),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function aE(e){this.enabled!==!1&&(e.pointerType==="touch"?this._onTouchMove(e):this._onMouseMove(e))}function nE(e){switch(this._removePointer(e),this._pointers.length){case 0:this.domElement.releasePointerCapture(e.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Cm),this.state=Tt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],i=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:i.x,pageY:i.y});break}}function sE(e){let t;switch(e.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Hn.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(e),this.state=Tt.DOLLY;break;case Hn.ROTATE:if(e.ctrlKey||e.metaKey||e.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(e),this.state=Tt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(e),this.state=Tt.ROTATE}break;case Hn.PAN:if(e.ctrlKey||e.metaKey||e.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(e),this.state=Tt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(e),this.state=Tt.PAN}break;default:this.state=Tt.NONE}this.state!==Tt.NONE&&this.dispatchEvent(Zc)}function oE(e){switch(this.state){case Tt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(e);break;case Tt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(e);break;case Tt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(e);break}}function lE(e){this.enabled===!1||this.enableZoom===!1||this.state!==Tt.NONE||(e.preventDefault(),this.dispatchEvent(Zc),this._handleMouseWheel(this._customWheelEvent(e)),this.dispatchEvent(Cm))}function hE(e){this.enabled!==!1&&this._handleKeyDown(e)}function cE(e){switch(this._trackPointer(e),this._pointers.length){case 1:switch(this.touches.ONE){case zn.ROTATE:if(this.enableRotate===!1){this.state=Tt.NONE;break}this._handleTouchStartRotate(e),this.state=Tt.TOUCH_ROTATE;break;case zn.PAN:if(this.enablePan===!1){this.state=Tt.NONE;break}this._handleTouchStartPan(e),this.state=Tt.TOUCH_PAN;break;default:this.state=Tt.NONE}break;case 2:switch(this.touches.TWO){case zn.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(e),this.state=Tt.TOUCH_DOLLY_PAN;break;case zn.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(e),this.state=Tt.TOUCH_DOLLY_ROTATE;break;default:this.state=Tt.NONE}break;default:this.state=Tt.NONE}this.state!==Tt.NONE&&this.dispatchEvent(Zc)}function uE(e){switch(this._trackPointer(e),this.state){case Tt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(e),this.update();break;case Tt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(e),this.update();break;case Tt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(e),this.update();break;case Tt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(e),this.update();break;default:this.state=Tt.NONE}}function dE(e){this.enabled!==!1&&e.preventDefault()}function fE(e){e.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function pE(e){e.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var dl=2,Pm=1014,Lm=1029;var Hs=`
uniform vec3 uStops[5];
uniform float uShares[5];
vec3 colourOf(float share) {
  vec3 c = uStops[0];
  for (int k = 1; k < 5; ++k) c = mix(c, uStops[k], clamp((share - uShares[k - 1]) / (uShares[k] - uShares[k - 1]), 0.0, 1.0));
  return c;
}`;var Gs=`
uniform vec3 uLow, uSize;  // of the box [m]
uniform float uMix;        // 0: at frame a, 1: at frame b
vec3 placed(vec4 a, vec4 b) { return uLow + uSize * (65535.0 / 65534.0) * mix(a.xyz, b.xyz, uMix); }`,Zn=`
float lightOn(vec3 n) { return 0.42 + 0.58 * max(0.0, dot(n, vec3(-0.33, 0.62, 0.71))); }`,Dm=(e,t,i)=>.42+.58*Math.max(0,-.33*e+.62*t+.71*i),Vs=`
uniform vec4 uClip;  // normal, distance
bool clipped(vec3 x) { return dot(x, uClip.xyz) > uClip.w; }`;function fl(e){return{uStops:{value:e.stops.flatMap(t=>t.map(i=>i/255))},uShares:{value:e.shares}}}function pl(e){return{uLow:{value:e.low},uSize:{value:e.size},uMix:{value:0}}}function eu(e,t){let i=[],r=[];for(let[a,n]of t)for(let s=0;s<e;++s)i.push([n*Math.cos(2*Math.PI*s/e),n*Math.sin(2*Math.PI*s/e),a]);for(let a=0;a+1<t.length;++a)for(let n=0;n<e;++n){let s=a*e+n,o=a*e+(n+1)%e;t[a][1]>0&&r.push(s,o,s+e),t[a+1][1]>0&&r.push(o,o+e,s+e)}return{points:i,corners:r}}var tu={tube:eu(8,[[0,0],[0,1],[1,1],[1,0]]),pipe:eu(5,[[0,1],[1,1]]),ball:eu(8,[0,1,2,3,4].map(e=>[(1-Math.cos(Math.PI*e/4))/2,e%4===0?0:Math.sin(Math.PI*e/4)]))},mE=`
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
}`,gE=`
${Zn}
uniform float uOpacity;
varying vec3 vColour, vEye;
void main() {
  vec3 n = normalize(cross(dFdx(vEye), dFdy(vEye)));
  gl_FragColor = vec4(vColour * lightOn(n.z < 0.0 ? -n : n), uOpacity);
}`,_E=6;function vE(e,t){return new Bi({vertexShader:mE,fragmentShader:gE,uniforms:{uOpacity:{value:t}},transparent:t<1,...e})}var Ws=class{constructor(t){this.shape=t,this.geometry=new pi,this.room=0,this.count=0}grow(){let{points:t,corners:i}=this.shape,r=this.arrays,a=Math.max(64,2*this.room),n=t.length,s=new Float32Array(3*n*a),o=new Uint32Array(i.length*a);for(let l=0;l<a;++l)t.forEach((h,c)=>s.set(h,3*(n*l+c))),i.forEach((h,c)=>o[i.length*l+c]=n*l+h);this.geometry.dispose(),this.arrays={from:new Float32Array(3*n*a),to:new Float32Array(3*n*a),tint:new Float32Array(3*n*a),radii:new Float32Array(2*n*a)},this.geometry.setIndex(new ii(o,1)),this.geometry.setAttribute("position",new ii(s,3));for(let[l,h]of Object.entries(this.arrays))r&&h.set(r[l]),this.geometry.setAttribute(l,new ii(h,l==="radii"?2:3));this.room=a}add(t,i,r,a,n){this.count===this.room&&this.grow();let s=this.shape.points.length,{arrays:o}=this;for(let l=0,h=s*this.count;l<s;++l,++h)o.from[3*h]=t[0],o.from[3*h+1]=t[1],o.from[3*h+2]=t[2],o.to[3*h]=i[0],o.to[3*h+1]=i[1],o.to[3*h+2]=i[2],o.tint[3*h]=n[0],o.tint[3*h+1]=n[1],o.tint[3*h+2]=n[2],o.radii[2*h]=r,o.radii[2*h+1]=a;++this.count}finish(){if(this.room!==0){this.geometry.setDrawRange(0,this.shape.corners.length*this.count);for(let t of Object.keys(this.arrays))this.geometry.attributes[t].needsUpdate=!0}}},iu=new Map;function ml(e){return iu.has(e)||iu.set(e,[1,3,5].map(t=>parseInt(e.slice(t,t+2),16)/255)),iu.get(e)}var mt=(e,t,i=1)=>[e[0]+i*t[0],e[1]+i*t[1],e[2]+i*t[2]],La=(e,t)=>[e[0]-t[0],e[1]-t[1],e[2]-t[2]],tr=(e,t)=>e[0]*t[0]+e[1]*t[1]+e[2]*t[2],oa=(e,t)=>[e[1]*t[2]-e[2]*t[1],e[2]*t[0]-e[0]*t[2],e[0]*t[1]-e[1]*t[0]],ir=e=>Math.hypot(e[0],e[1],e[2]),Ri=(e,t=[0,0,1])=>{let i=ir(e);return i>1e-12?[e[0]/i,e[1]/i,e[2]/i]:t},Qa=(e,t,i)=>[e[0]+i*(t[0]-e[0]),e[1]+i*(t[1]-e[1]),e[2]+i*(t[2]-e[2])],en=e=>Ri(oa(e,Math.abs(e[2])<.9?[0,0,1]:[1,0,0])),Za=class{constructor({ghost:t=0,above:i=!1}={}){this.tubes=new Ws(tu.tube),this.pipes=new Ws(tu.pipe),this.balls=new Ws(tu.ball),this.ghosts=[],this.object=new Ti;for(let{geometry:r}of[this.tubes,this.pipes,this.balls]){let a=[[i?{depthTest:!1,depthWrite:!1}:{},1,i?10:1]];t>0&&a.push([{depthFunc:_E,depthWrite:!1},t,2]);for(let[n,s,o]of a){let l=new Di(r,vE(n,s));l.frustumCulled=!1,l.renderOrder=o,s<1&&this.ghosts.push(l),this.object.add(l)}}}begin(){this.tubes.count=this.pipes.count=this.balls.count=0}showGhosts(t){for(let i of this.ghosts)i.visible=t}tube(t,i,r,a){this.tubes.add(t,i,r,r,ml(a))}cone(t,i,r,a,n){this.tubes.add(t,i,r,a,ml(n))}ball(t,i,r){this.balls.add([t[0],t[1],t[2]-i],[t[0],t[1],t[2]+i],i,i,ml(r))}line(t,i,r){for(let a=0;a+1<t.length;++a)this.pipes.add(t[a],t[a+1],i,i,ml(r))}arrow(t,i,r,a){let n=La(i,t),s=ir(n);if(!(s>0))return;let o=Math.min(2.4*r,.6*s),l=Qa(t,i,1-o/s),h=.5*r*o/(2.4*r);this.tube(t,l,.36*h,a),this.cone(l,i,h,0,a)}arc(t,i,r,a,n,s,o=!0){let l=en(i),h=oa(i,l),c=12,d=[];for(let u=0;u<=c;++u){let f=2*Math.PI*a*u/c;d.push(mt(mt(t,l,r*Math.cos(f)),h,r*Math.sin(f)))}this.line(o?d.slice(0,c-1):d,.3*n,s),o&&this.cone(d[c-2],d[c],n,0,s)}finish(){this.tubes.finish(),this.pipes.finish(),this.balls.finish()}};var xE="#c2006b",ME=.22,SE=1e-4,gl=class{constructor(t,i,r,a){Object.assign(this,{history:t,marks:a}),this.solids=new Za({above:!0}),this.object=new Ti().add(this.solids.object),this.entries=[];let n=0;i.forEach((s,o)=>{let l=u=>u.map(f=>t.columns.get(`${s}.${f}`)?.values),h=a?.index("body",s)??-1,c=l(["contact.fx","contact.fy","contact.fz"]),d=l(["contact.mx","contact.my","contact.mz"]);if(c.every(Boolean))for(let u=0;u<t.time.length;++u)n=Math.max(n,Math.hypot(c[0][u],c[1][u],c[2][u]));else if(h>=0)for(let u=0;u<a.times.length;++u)n=Math.max(n,ir(a.vector(h,2,{k:u,next:u,mix:0})));else return;this.entries.push({body:o,mark:h,force:c,moment:d,place:l(["x","y","z"])})}),this.largest=n,this.longest=ME*r,this.width=.017*r}show(t,i,r=!0){if(this.solids.begin(),this.object.visible)for(let{body:a,mark:n,force:s,moment:o,place:l}of this.entries){let h=p=>p.map(m=>Du(this.history,m,t)),c=this.marks?.moment(t,r),d=s.every(Boolean)?h(s):this.marks.vector(n,2,c),u=ir(d);if(!(u>SE*this.largest))continue;let f=n>=0?this.marks.vector(n,0,c):l.every(Boolean)?h(l):i(a);if(f===null)continue;let _=s.every(Boolean)?o.every(Boolean)?h(o):null:this.marks.vector(n,3,c),x=_?mt(f,oa(d,_),1/tr(d,d)):f;this.solids.arrow(x,mt(x,Ri(d),this.longest*Math.sqrt(u/this.largest)),this.width,xE)}this.solids.finish()}};var Nm=`
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
}`,yE=`
${Hs}${Gs}${Vs}${Nm}
attribute vec4 a, b;
void main() {
  paint(mix(a.w, b.w, uMix), placed(a, b));
}`,EE=`
${Hs}${Gs}${Vs}${Nm}
attribute vec4 a0, a1, b0, b1;
attribute float radius;
void main() {
  vec3 from = placed(a0, b0), to = placed(a1, b1), axis = normalize(to - from + vec3(0.0, 0.0, 1e-12));
  vec3 side = normalize(cross(axis, abs(axis.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
  vec3 x = mix(from, to, position.z) + radius * (position.x * side + position.y * cross(axis, side));
  paint(mix(a0.w, b0.w, uMix), x);
}`,bE=`
${Zn}
varying vec3 vColour, vEye;
varying float vBehind;
void main() {
  if (vBehind > 0.0) discard;
  vec3 n = normalize(cross(dFdx(vEye), dFdy(vEye)));
  gl_FragColor = vec4(vColour * lightOn(n.z < 0.0 ? -n : n), 1.0);
}`,Qn=(()=>{let t=[],i=[],r=[[],[]];for(let a=0;a<2*8;++a){let n=2*Math.PI*(a%8)/8;t.push([Math.cos(n),Math.sin(n),a<8?0:1])}t.push([0,0,0],[0,0,1]);for(let a=0;a<8;++a){let n=(a+1)%8;i.push(a,n,8+n,a,8+n,8+a),r[0].push(n,a,2*8),r[1].push(8+a,8+n,2*8+1)}return{points:t,corners:i,ends:r}})();function wE(e,t){let i=(B,I)=>I.map((L,G)=>L-B[G]),r=(B,I)=>B[0]*I[0]+B[1]*I[1]+B[2]*I[2],a=(B,I)=>Math.min(1,Math.max(0,r(i(B,I),i(B,t))/(r(i(B,I),i(B,I))||1))),[n,s,o]=e;if(e.length===2)return[1-a(n,s),a(n,s)];let l=i(n,s),h=i(n,o),c=i(n,t),d=i(s,t),u=i(o,t),f=r(l,c),_=r(h,c),x=r(l,d),p=r(h,d),m=r(l,u),w=r(h,u),R=x*w-m*p,E=m*_-f*w,T=f*p-x*_,P=R+E+T;if(R>0&&E>0&&T>0)return[R/P,E/P,T/P];let v=[[0,1],[1,2],[2,0]].map(([B,I])=>{let L=a(e[B],e[I]),G=e[B].map((Z,O)=>Z+L*(e[I][O]-Z));return{i:B,j:I,s:L,distance:Math.hypot(G[0]-t[0],G[1]-t[1],G[2]-t[2])}}),{i:b,j:U,s:W}=v.reduce((B,I)=>I.distance<B.distance?I:B),N=[0,0,0];return N[b]+=1-W,N[U]+=W,N}var tn=class{constructor(t,i){this.spec=t,this.colours=Iu(i),this.times=t.times,this.frames=[],this.uniforms={...fl(pa.stress),...pl(t.box),uClip:{value:new Ft},uStress:{value:!1}},this.object=new Ti,this.shown=[-1,-1]}material(t){return new Bi({vertexShader:t,fragmentShader:bE,uniforms:this.uniforms,side:dl})}async loadFirst(){this.radius=null;let t=async(l,h)=>mn(await Fa(`bodies-${l}`),h);this.triangles=await t("triangles",Uint32Array),this.lines=await t("lines",Uint32Array),this.cellBody=await t("cells",Uint32Array);let i=this.radius=await t("radius",Float32Array);this.decoder=new pn(3*this.spec.points+(this.spec.stress>0?this.spec.cells:0));let r=this.triangles.length/3,a=this.lines.length/2,n=(l,h)=>{let c=new lt,d=new Float32Array(4*h*l.length);return l.forEach((u,f)=>{let _=this.cellBody[u];c.set(this.colours[_%this.colours.length]??"#8fa6bd").convertLinearToSRGB();for(let x=0;x<h;++x)d.set([c.r,c.g,c.b,this.spec.stressed.includes(_)?1:0],4*(h*f+x))}),d},s=(l,h)=>Array.from({length:h},(c,d)=>l+d),o=l=>new ii(new Uint16Array(4*l),4,!0);if(r>0){let l=new pi;l.setAttribute("tint",new ii(n(s(0,r),3),4));for(let h of["a","b"])l.setAttribute(h,o(3*r));l.setAttribute("position",l.attributes.a),this.plates=new Di(l,this.material(yE))}if(a>0){let l=new pi;l.setIndex(this.tubeCorners()),l.setAttribute("position",new Ai(Array(a).fill(Qn.points.flat()).flat(),3));let h=Qn.points.length;l.setAttribute("tint",new ii(n(s(r,a),h),4)),l.setAttribute("radius",new ii(Float32Array.from({length:h*a},(c,d)=>i[d/h|0]),1));for(let c of["a0","a1","b0","b1"])l.setAttribute(c,o(h*a));this.tubes=new Di(l,this.material(EE))}for(let l of[this.plates,this.tubes])l&&(l.frustumCulled=!1,this.object.add(l));await this.loadNext(),this.show(this.times[0],!0)}async loadNext(){let t=this.frames.length;return t===this.times.length?!1:(this.frames.push(this.decoder.next(await Fa(`bodies-${t}`))),!0)}tubeCorners(){let t=this.lines.length/2,i=new Map,r=[];for(let a of this.lines)i.set(a,(i.get(a)??0)+1);for(let a=0;a<t;++a){let n=[0,1].filter(s=>i.get(this.lines[2*a+s])===1);for(let s of[Qn.corners,...n.map(o=>Qn.ends[o])])for(let o of s)r.push(a*Qn.points.length+o)}return r}static put(t,i,r,a,n,s){t[4*i]=r[n],t[4*i+1]=r[a+n],t[4*i+2]=r[2*a+n],t[4*i+3]=s}fill(t,i){let r=this.frames[i],a=this.spec.points,n=this.triangles.length/3,s=o=>this.spec.stress>0?r[3*a+o]:0;if(this.plates){let o=this.plates.geometry.attributes[t];for(let l=0;l<this.triangles.length;++l)tn.put(o.array,l,r,a,this.triangles[l],s(l/3|0));o.needsUpdate=!0}if(this.tubes)for(let o of[0,1]){let l=this.tubes.geometry.attributes[t+o],h=Qn.points.length;for(let c=0;c<h*this.lines.length/2;++c){let d=c/h|0;tn.put(l.array,c,r,a,this.lines[2*d+o],s(n+d))}l.needsUpdate=!0}}show(t,i){let r=this.frames.length-1,a=Math.min(ka(this.times,t),r),n=i?Math.min(a+1,r):a,s=this.times[n]-this.times[a];return this.uniforms.uMix.value=s>0?Math.min(1,Math.max(0,(t-this.times[a])/s)):0,this.shown[0]!==a&&this.fill("a",a),this.shown[1]!==n&&this.fill("b",n),this.shown=[a,n],a}has(t){return this.cellsOf??=this.cellsByBody(),this.cellsOf.has(t)}cellsByBody(){let t=new Map;return this.cellBody.forEach((i,r)=>t.has(i)?t.get(i).push(r):t.set(i,[r])),t}cornersOf(t){let i=this.triangles.length/3;return t<i?[0,1,2].map(r=>this.triangles[3*t+r]):[0,1].map(r=>this.lines[2*(t-i)+r])}pointOf(t,i){let{low:r,size:a}=this.spec.box,n=this.spec.points;return[0,1,2].map(s=>r[s]+a[s]*t[s*n+i]/65534)}nearest(t,i){if(!this.has(t))return null;let r=this.triangles.length/3,a=null;for(let n of this.cellsOf.get(t)){let s=this.cornersOf(n),o=wE(s.map(c=>this.pointOf(this.frames[0],c)),i),l=[0,1,2].map(c=>s.reduce((d,u,f)=>d+o[f]*this.pointOf(this.frames[0],u)[c],0)),h=Math.max(0,Math.hypot(l[0]-i[0],l[1]-i[1],l[2]-i[2])-(n<r?0:this.radius[n-r]));(!a||h<a.gap)&&(a={corners:s,weights:o,gap:h})}return a}place({corners:t,weights:i}){let r=this.uniforms.uMix.value,[a,n]=this.shown.map(o=>this.frames[o]),s=[0,0,0];return t.forEach((o,l)=>{let h=this.pointOf(a,o),c=this.pointOf(n,o);for(let d=0;d<3;++d)s[d]+=i[l]*(h[d]+r*(c[d]-h[d]))}),s}centre(t){this.pointsOf??=this.pointsByBody();let i=this.pointsOf.get(t);if(!i)return null;let{low:r,size:a}=this.spec.box,n=this.spec.points,s=this.uniforms.uMix.value,[o,l]=this.shown.map(h=>this.frames[h]);return[0,1,2].map(h=>{let c=0;for(let d of i)c+=o[h*n+d]+s*(l[h*n+d]-o[h*n+d]);return r[h]+a[h]*c/i.length/65534})}pointsByBody(){let t=new Map,i=(a,n)=>{let s=this.cellBody[a];t.has(s)||t.set(s,new Set),t.get(s).add(n)},r=this.triangles.length/3;return this.triangles.forEach((a,n)=>i(n/3|0,a)),this.lines.forEach((a,n)=>i(r+(n/2|0),a)),new Map([...t].map(([a,n])=>[a,[...n]]))}};var Im=16383,es=64,rn=128,jr=64,an=2,TE=`
uniform vec4 uBounds;  // of the picture that holds grains, -1 ... 1
void main() { gl_Position = vec4(mix(uBounds.xy, uBounds.zw, position.xy), 0.0, 1.0); }`,AE=`
precision highp usampler2D;
uniform usampler2D uPixels;
uniform float uNear, uStep;
uniform mat4 uProjection;
void main() {
  uint pixel = texelFetch(uPixels, ivec2(gl_FragCoord.xy), 0).r;
  if (pixel == 0u) discard;
  gl_FragColor = vec4(vec3((uvec3(pixel) >> uvec3(26u, 20u, 14u)) & 63u) / 63.0, 1.0);
  gl_FragDepth = 0.5 + 0.5 * (uProjection[3][2] / (uNear + uStep * float((pixel & 16383u) - 1u)) - uProjection[2][2]);
}`,vl=class{constructor(t,i,r){this.discs=new Float32Array(4*t),this.grain=new Uint32Array(t),this.steps=new Uint16Array(t),this.order=new Uint32Array(t),this.places=new Uint32Array(Im+2),this.makeTables(i,r);let a=new pi;a.setAttribute("position",new ii(new Float32Array([0,0,0,1,0,0,0,1,0,0,1,0,1,0,0,1,1,0]),3)),this.uniforms={uPixels:{value:null},uBounds:{value:new Ft},uNear:{value:0},uStep:{value:0},uProjection:{value:null}},this.object=new Di(a,new Bi({vertexShader:TE,fragmentShader:AE,uniforms:this.uniforms})),this.object.frustumCulled=!1}makeTables(t,i){this.light=new Uint8Array(jr*jr);let r=.42,a=1;for(let n=0;n<jr;++n)for(let s=0;s<jr;++s){let o=(2*s+1)/jr-1,l=(2*n+1)/jr-1,h=Math.sqrt(Math.max(0,1-o*o-l*l)),c=(i(o,l,h)-r)/(a-r);this.light[n*jr+s]=Math.round((es-1)*Math.min(1,Math.max(0,c)))}this.palette=new Int32Array(2*rn*es);for(let n=0;n<2*rn;++n){let s=n%rn/(rn-1),o=n<rn?1:.8+(1-.8)*Math.min(1,s/.12),l=1;for(;l<t.shares.length-1&&s>t.shares[l];)++l;let h=(s-t.shares[l-1])/(t.shares[l]-t.shares[l-1]);for(let c=0;c<es;++c)for(let d=0;d<3;++d){let u=t.stops[l-1][d]+h*(t.stops[l][d]-t.stops[l-1][d]),f=Math.min(63,Math.round(o*u*(r+(a-r)*c/(es-1))*63/255));this.palette[n*es+c]|=f<<26-6*d}}}resize(t,i){if(this.width===t&&this.height===i)return;Object.assign(this,{width:t,height:i}),this.uniforms.uPixels.value?.dispose(),this.pixels=new Int32Array(t*i);let r=new Yc(new Uint32Array(this.pixels.buffer),t,i,Lm,Pm);r.internalFormat="R32UI",this.uniforms.uPixels.value=r;let a=1<<an,n=Math.ceil(t/a),s=Math.ceil(i/a);this.columns=n,this.free=new Uint8Array(n*s),this.empty=Uint8Array.from(this.free,(o,l)=>Math.min(a,t-a*(l%n))*Math.min(a,i-a*(l/n|0)))}paint({a:t,b:i,mix:r,box:a,radius:n,camera:s,clip:o,width:l,height:h,share:c,odd:d}){this.resize(l,h);let{nearest:u,step:f,count:_}=this.place({a:t,b:i,mix:r,box:a,radius:n,camera:s,clip:o,width:l,height:h});this.sort(_,u,f),this.pixels.fill(0),this.free.set(this.empty);for(let x=0;x<_;++x){let p=this.order[x];if(this.covered(p))continue;let m=this.grain[p];this.disc(p,c,d,m,i[4*m]===65535?0:r)}return this.uniforms.uNear.value=u,this.uniforms.uStep.value=f,this.uniforms.uProjection.value=s.projectionMatrix,this.uniforms.uPixels.value.needsUpdate=!0,_}place({a:t,b:i,mix:r,box:a,radius:n,camera:s,clip:o,width:l,height:h}){let{discs:c,grain:d}=this,u=s.matrixWorldInverse.elements,f=s.projectionMatrix.elements[5]*.5*h,{low:_,size:x}=a,p=x[0]/65534,m=x[1]/65534,w=x[2]/65534,R=s.near,E=u[0]*p,T=u[4]*m,P=u[8]*w,v=u[0]*_[0]+u[4]*_[1]+u[8]*_[2]+u[12],b=u[1]*p,U=u[5]*m,W=u[9]*w,N=u[1]*_[0]+u[5]*_[1]+u[9]*_[2]+u[13],B=-u[2]*p,I=-u[6]*m,L=-u[10]*w,G=-(u[2]*_[0]+u[6]*_[1]+u[10]*_[2]+u[14]),Z=o.x*p,O=o.y*m,de=o.z*w,J=o.x*_[0]+o.y*_[1]+o.z*_[2]-o.w,te=1/0,ne=0,Le=0,K=l,re=0,se=h,Ce=0;for(let le=0,Fe=0;le<n.length;++le,Fe+=4){let We=t[Fe],we=t[Fe+1],at=t[Fe+2];if(We===65535||(i[Fe]!==65535&&(We+=r*(i[Fe]-We),we+=r*(i[Fe+1]-we),at+=r*(i[Fe+2]-at)),Z*We+O*we+de*at+J>0))continue;let _t=B*We+I*we+L*at+G;if(_t<R)continue;let Mt=f/_t,$e=Math.max(.5,Mt*n[le]),St=.5*l+Mt*(E*We+T*we+P*at+v),Nt=.5*h+Mt*(b*We+U*we+W*at+N);if(St<-$e||Nt<-$e||St>l+$e||Nt>h+$e)continue;let vt=4*Le;c[vt]=St,c[vt+1]=Nt,c[vt+2]=$e,c[vt+3]=_t,d[Le++]=le,_t<te&&(te=_t),_t>ne&&(ne=_t),St-$e<K&&(K=St-$e),St+$e>re&&(re=St+$e),Nt-$e<se&&(se=Nt-$e),Nt+$e>Ce&&(Ce=Nt+$e)}let Re=(le,Fe)=>Math.min(1,Math.max(-1,2*le/Fe-1));return this.uniforms.uBounds.value.set(Re(K-1,l),Re(se-1,h),Re(re+1,l),Re(Ce+1,h)),{nearest:te,step:(ne-te||1)/(Im-1),count:Le}}sort(t,i,r){let{places:a,steps:n,order:s,discs:o}=this;a.fill(0);for(let l=0;l<t;++l)++a[(n[l]=1+((o[4*l+3]-i)/r|0))+1];for(let l=1;l<a.length;++l)a[l]+=a[l-1];for(let l=0;l<t;++l)s[a[n[l]]++]=l}covered(t){let{discs:i,free:r,columns:a,width:n,height:s}=this,o=i[4*t],l=i[4*t+1],h=i[4*t+2],c=Math.max(0,o-h)>>an,d=Math.min(n-1,o+h)>>an,u=Math.min(s-1,l+h)>>an;for(let f=Math.max(0,l-h)>>an;f<=u;++f)for(let _=f*a+c;_<=f*a+d;++_)if(r[_]!==0)return!1;return!0}disc(t,i,r,a,n){let{width:s,height:o,pixels:l,light:h,palette:c,free:d,columns:u,discs:f}=this,_=f[4*t],x=f[4*t+1],p=f[4*t+2],m=p*p,w=this.steps[t],R=(.5*jr-.01)/p,E=.5*jr,T=Math.min(o-1,Math.floor(x+p-.5)),P=-1;for(let v=Math.max(0,Math.ceil(x-p-.5));v<=T;++v){let b=v+.5-x,U=Math.sqrt(Math.max(0,m-b*b)),W=Math.max(0,Math.ceil(_-U-.5)),N=Math.min(s-1,Math.floor(_+U-.5)),B=jr*(b*R+E|0),I=(v>>an)*u;for(let L=W,G=v*s+W;L<=N;++L,++G)l[G]===0&&(P<0&&(P=es*(r[a]*rn+Math.round((rn-1)*Math.min(1,Math.max(0,i(a,n)))))),l[G]=c[P+h[B+((L+.5-_)*R+E|0)]]|w,--d[I+(L>>an)])}}};var RE=`
${Hs}${Gs}${Vs}
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
  if (start.x < 1.0 && fract(0.5 * floor(start.z * uLayers)) > 0.25) vColour *= mix(${.8 .toFixed(3)}, 1.0, min(1.0, share / ${.12 .toFixed(3)}));
  vec4 eye = modelViewMatrix * vec4(x, 1.0);
  gl_Position = projectionMatrix * eye;
  gl_PointSize = max(1.0, radius * projectionMatrix[1][1] * uPixels / gl_Position.w);
  if (a.x >= 1.0 || clipped(x)) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
}`,CE=`
${Zn}
flat in vec3 vColour;
void main() {
  vec2 p = 2.0 * gl_PointCoord - 1.0;
  float h = 1.0 - dot(p, p);
  if (h < 0.0) discard;
  gl_FragColor = vec4(vColour * lightOn(vec3(p.x, -p.y, sqrt(h))), 1.0);
}`,xl=class{constructor(t){this.spec=t,this.times=t.times,this.frames=[],this.geometry=new pi,this.material=new Bi({vertexShader:RE,fragmentShader:CE,uniforms:{...fl(pa.sand),...pl(t.box),uClip:{value:new Ft},uPixels:{value:1},uColour:{value:0},uLargest:{value:1},uUpper:{value:1},uLayers:{value:1}}}),this.all=new rm(this.geometry,this.material),this.all.frustumCulled=!1,this.object=new Ti().add(this.all)}async loadFirst(){let t=mn(await Fa("grains-radius"),Float32Array);this.geometry.setAttribute("radius",new ii(t,1)),this.radius=t,this.decoder=new pn(this.spec.count*(3+this.spec.numbers.length)),await this.loadNext(),this.geometry.setAttribute("start",this.frames[0].positions),this.findLayers(),this.setNumber(0),this.show(this.times[0],!0)}findLayers(){let{low:t,high:i}=this.spec.view,r=i[2]-t[2],a=this.frames[0].positions.array,n=this.spec.count,s=Math.max(r/6,3*this.radius.reduce((h,c)=>h+c,0)/Math.max(1,n))||1,o=10**Math.floor(Math.log10(s));this.layer=[1,2,5,10].map(h=>h*o).find(h=>h>=.99*s)??10*o;let l=(this.spec.box.size[2]||this.layer)/this.layer;this.material.uniforms.uLayers.value=l,this.odd=Uint8Array.from({length:n},(h,c)=>a[4*c]===65535?0:Math.floor(a[4*c+2]/65535*l)&1)}async loadNext(){let t=this.frames.length;if(t===this.times.length)return!1;let i=this.decoder.next(await Fa(`grains-${t}`)),r=this.spec.count,a=new Uint16Array(4*r);for(let s=0;s<r;++s)a[4*s]=i[s],a[4*s+1]=i[r+s],a[4*s+2]=i[2*r+s];let n=this.spec.numbers.map((s,o)=>i.slice((3+o)*r,(4+o)*r));return this.frames.push({positions:new ii(a,4,!0),numbers:n}),t>0&&this.fill(this.frames[t]),!0}fill(t){let i=t.numbers[this.number],r=t.positions.array;if(i)for(let a=0;a<this.spec.count;++a)r[4*a+3]=i[a]*257;t.positions.needsUpdate=!0}setNumber(t){this.number=t;for(let i of this.frames)this.fill(i)}colours(){return[...this.spec.numbers.map(i=>({name:i.name,unit:i.unit,largest:i.shown})),{name:"displacement",unit:"m",largest:this.spec.farthest},{name:"plain"}]}setColour(t){let i=this.material.uniforms,r=this.spec.numbers.findIndex(a=>a.name===t);r>=0?(i.uColour.value=1,i.uUpper.value=this.spec.numbers[r].shown/this.spec.numbers[r].largest,r!==this.number&&this.setNumber(r)):(i.uColour.value=t==="displacement"?2:0,i.uLargest.value=this.spec.farthest||1)}show(t,i){let r=this.frames.length-1,a=Math.min(ka(this.times,t),r),n=Math.min(a+1,r),s=this.times[n]-this.times[a];return this.material.uniforms.uMix.value=i&&s>0?Math.min(1,Math.max(0,(t-this.times[a])/s)):0,this.geometry.setAttribute("a",this.frames[a].positions),this.geometry.setAttribute("b",this.frames[i?n:a].positions),this.geometry.setAttribute("position",this.frames[a].positions),this.shown=[this.frames[a],this.frames[i?n:a]],a}paint(t,i,r,a){if(this.all.visible=!t,this.painter&&(this.painter.object.visible=t),!t)return;this.painter||(this.painter=new vl(this.spec.count,pa.sand,Dm),this.object.add(this.painter.object));let n=this.material.uniforms,[s,o]=this.shown.map(h=>h.positions.array),l={a:s,b:o,mix:n.uMix.value,box:this.spec.box,radius:this.radius,camera:i,clip:n.uClip.value,width:r,height:a};this.painter.paint({...l,share:this.shareOfColours(s,o),odd:this.odd})}shareOfColours(t,i){let r=this.material.uniforms,a=r.uColour.value;if(a===1){let l=r.uUpper.value*65535*65535;return(h,c)=>{let d=t[4*h+3]+c*(i[4*h+3]-t[4*h+3]);return d*d/l}}if(a!==2)return()=>0;let n=this.frames[0].positions.array,s=r.uLargest.value,{size:o}=this.spec.box;return(l,h)=>{let c=4*l;if(n[c]===65535)return 0;let d=0;for(let u=0;u<3;++u){let f=o[u]*(t[c+u]+h*(i[c+u]-t[c+u])-n[c+u])/65534;d+=f*f}return Math.sqrt(d)/s}}};var au=12,Ml=class{constructor(t){this.times=t.times,this.list=t.list,this.byName=new Map(t.list.map((i,r)=>[`${i.kind}:${i.name}`,r]))}async load(){this.numbers=await Il("marks",Float32Array)}moment(t,i){let r=ka(this.times,t),a=i?Math.min(r+1,this.times.length-1):r,n=this.times[a]-this.times[r];return{k:r,next:a,mix:n>0?Math.min(1,Math.max(0,(t-this.times[r])/n)):0}}vector(t,i,{k:r,next:a,mix:n}){let s=au*this.list.length,o=r*s+au*t+3*i,l=a*s+au*t+3*i,h=this.numbers;return[h[o]+n*(h[l]-h[o]),h[o+1]+n*(h[l+1]-h[o+1]),h[o+2]+n*(h[l+2]-h[o+2])]}way(t){return this.times.map((i,r)=>this.vector(t,0,{k:r,next:r,mix:0}))}index(t,i){return this.byName.get(`${t}:${i}`)??-1}};var Sl=30,PE=200,LE=6.3,Um=12,Om=["joint","drive","strut","spring","force","body"],yl=class{constructor(t,i){this.stage=i,this.corner=document.createElement("div"),this.corner.className="corner",this.labels=document.createElement("div"),this.labels.className="names",t.append(this.labels,this.corner),this.named=!1}show(){this.showCorner(),this.showNames()}showCorner(){let{camera:t,run:i}=this.stage,r=t.matrixWorldInverse.elements,a=h=>[r[0]*h[0]+r[4]*h[1]+r[8]*h[2],-(r[1]*h[0]+r[5]*h[1]+r[9]*h[2])],n=[["x",[1,0,0],"#b3261e",Sl],["y",[0,1,0],"#1f7a3d",Sl],["z",[0,0,1],"#1d5fae",Sl]],s=i.gravity??[0,0,0],o=Math.sqrt(tr(s,s));o>0&&n.push([`g ${zi(o,3)} m/s\xB2`,s.map(h=>h/o),"#222",1.3*Sl]);let l=n.map(([,h])=>a(h).map(c=>c.toFixed(3))).join();l!==this.cornerShown&&(this.cornerShown=l,this.corner.innerHTML=`<svg viewBox="-60 -60 120 120">${n.map(([h,c,d,u])=>{let[f,_]=a(c).map(v=>v*u),x=Math.hypot(f,_)||1,p=Math.min(7,.5*x),m=f/x,w=_/x,R=f-m*p,E=_-w*p,T=.45*p,P=[[f,_],[R-w*T,E+m*T],[R+w*T,E-m*T]].map(v=>v.map(b=>b.toFixed(2)).join()).join(" ");return`<line x1="0" y1="0" x2="${R}" y2="${E}" stroke="${d}" stroke-width="2"/><polygon points="${P}" fill="${d}"/><text x="${f+8*m}" y="${_+9*w+4}" fill="${d}" text-anchor="middle">${h}</text>`}).join("")}</svg>`)}showNames(){let{stage:t}=this;if(this.labels.hidden=!this.named||!t.symbols,this.labels.hidden)return;let{clientWidth:i,clientHeight:r}=t.place,a=new X,n=t.symbols.names(t.time,t.smooth).sort((o,l)=>Om.indexOf(o.kind)-Om.indexOf(l.kind)).slice(0,PE),s=[];for(;this.labels.childElementCount>n.length;)this.labels.lastChild.remove();n.forEach(({text:o,kind:l,place:h},c)=>{let d=this.labels.children[c]??this.labels.appendChild(document.createElement("span"));a.set(...h).project(t.camera),d.textContent=o,d.className=l;let u=(a.x+1)*i/2+6,f=(1-a.y)*r/2,_=u+LE*o.length,x=a.z<=1&&!s.some(p=>u<p.right&&p.x<_&&Math.abs(f-p.y)<Um);d.hidden=!x,x&&s.push({x:u,y:f,right:_}),d.style.transform=`translate(${u}px,${f-.5*Um}px)`})}};var pt={joint:"#1f4e79",axis:"#5b8db8",bracket:"#8b95a1",ground:"#6b6257",strut:"#5a6673",gas:"#56b4e9",mr:"#8e5bd0",honeycomb:"#d6a419",spring:"#e08a1e",table:"#5a6673",stops:"#5a6673",drive:"#c2006b",gear:"#00857c",force:"#d1272b",cable:"#2b2b2b",track:"#d55e00",mass:"#333f4c"},DE=.009,NE=5,nu=[{name:"struts",text:"struts, springs, cables",kinds:["strut","spring","cable"],on:!0},{name:"joints",text:"joints",kinds:["joint"],on:!0},{name:"drives",text:"drives, gears",kinds:["drive","gear"],on:!0},{name:"forces",text:"given forces",kinds:["force"],on:!0},{name:"brackets",text:"brackets to bodies",kinds:[],on:!0}],El=class{constructor(t,i,r,a,n){Object.assign(this,{marks:t,bodies:i,up:n}),this.u=DE*a,this.solids=new Za({ghost:.28}),this.tracks=new Za({above:!0}),this.object=new Ti().add(this.solids.object,this.tracks.object),this.on=Object.fromEntries(nu.map(({name:o,on:l})=>[o,l])),this.layerOf=Object.fromEntries(nu.flatMap(({name:o,kinds:l})=>l.map(h=>[h,o]))),this.bodyNumber=new Map(r.map((o,l)=>[o,l]));let s={k:0,next:0,mix:0};this.lengths=t.list.map((o,l)=>ir(La(t.vector(l,1,s),t.vector(l,0,s)))),this.largest={force:this.largestOf("force",2),torque:this.largestOf("force",3),drive:this.largestOf("drive",2)},this.findBrackets(s)}layers(){let t=new Set(this.marks.list.map(i=>i.kind));return nu.filter(i=>i.name==="brackets"?this.brackets.length>0:i.kinds.some(r=>t.has(r)))}largestOf(t,i){let r=0;return this.marks.list.forEach((a,n)=>{if(a.kind===t)for(let s=0;s<this.marks.times.length;++s)r=Math.max(r,ir(this.marks.vector(n,i,{k:s,next:s,mix:0})))}),r}findBrackets(t){this.brackets=[];let i=new Set;this.marks.list.forEach((r,a)=>{r.kind==="body"||r.kind==="gear"||r.kind==="drive"||r.bodies.forEach((n,s)=>{let o=this.marks.vector(a,s,t),l=`${n} ${o.map(d=>Math.round(d/(.1*this.u)))}`;if(i.has(l))return;if(i.add(l),n==="ground"){this.brackets.push({mark:a,end:s,ground:!0});return}let h=this.bodies?.nearest(this.bodyNumber.get(n),o);if(h){h.gap>.3*this.u&&this.brackets.push({mark:a,end:s,near:h});return}let c=this.marks.index("body",n);c>=0&&ir(La(o,this.marks.vector(c,0,t)))>.3*this.u&&this.brackets.push({mark:a,end:s,centre:c})})}),this.hidden=this.marks.list.flatMap((r,a)=>r.kind==="body"&&!this.bodies?.has(this.bodyNumber.get(r.name))?[a]:[])}show(t,i){let{solids:r,marks:a,u:n}=this,s=a.moment(t,i);if(r.begin(),this.object.visible){for(let o of this.hidden)r.ball(a.vector(o,0,s),1.5*n,pt.mass);if(this.on.brackets)for(let o of this.brackets)this.bracket(o,s);a.list.forEach((o,l)=>{this.on[this.layerOf[o.kind]]&&this[o.kind]?.(o,l,[0,1,2,3].map(h=>a.vector(l,h,s)))})}r.finish(),this.showTrack(s,t)}bracket({mark:t,end:i,ground:r,near:a,centre:n},s){let{solids:o,marks:l,u:h}=this,c=l.vector(t,i,s);if(r){let d=mt(c,this.up,-2.4*h);o.cone(d,c,1.3*h,.3*h,pt.ground),o.tube(mt(d,this.up,-.3*h),d,1.9*h,pt.ground)}else o.tube(c,a?this.bodies.place(a):l.vector(n,0,s),.45*h,pt.bracket)}axis(t,i,r=NE){this.solids.tube(mt(t,i,-r*this.u),mt(t,i,r*this.u),.16*this.u,pt.axis)}barrel(t,i,r,a,n=pt.joint){this.solids.tube(mt(t,i,-r*this.u),mt(t,i,r*this.u),a*this.u,n)}joint({type:t},i,[r,a,n,s]){let{solids:o,u:l}=this,h=Qa(r,a,.5),c=Ri(n),d=Ri(s,en(c)),u={fixed:()=>this.barrel(h,c,.8,1.1),spherical:()=>o.ball(h,1.4*l,pt.joint),universal:()=>{for(let f of[c,d])this.axis(h,f,3.4),this.barrel(h,f,2,.75)},constant_velocity:()=>{o.ball(h,1.2*l,pt.joint);for(let f of[c,d])this.axis(h,f,3.4)},revolute:()=>{this.axis(h,c),this.barrel(h,c,1.8,1.1)},cylindrical:()=>{this.axis(h,c),this.barrel(h,c,2.6,.9)},prismatic:()=>{this.axis(h,c);for(let f of[-1.3,1.3])this.barrel(mt(h,c,f*l),c,.45,1.35)},planar:()=>{this.axis(h,c,3),this.barrel(h,c,.15,3.2)},prescribed:()=>{this.axis(h,c,4),this.barrel(h,c,1.4,1.2,pt.drive)},distance:()=>{for(let f of[r,a])o.ball(f,.9*l,pt.joint);o.tube(r,a,.4*l,pt.joint)},point_on_plane:()=>{let f=mt(a,c,-tr(La(a,r),c));o.ball(a,1.1*l,pt.joint),this.barrel(f,c,.15,3.2)},rolling:()=>this.solids.tube(mt(a,d,-.25*l),mt(a,d,.25*l),ir(s),pt.axis),rolling_ball:()=>o.ball(a,1.1*l,pt.joint)};(u[t]??u.fixed)()}strut({type:t},i,[r,a]){let{solids:n,u:s}=this,o=t.split("+"),l=Ri(La(a,r)),h=this.lengths[i];for(let u of[r,a])n.ball(u,.8*s,pt.strut);n.tube(r,a,.34*s,pt.strut);let c=o.filter(u=>["gas","mr","honeycomb","table"].includes(u));c.length===0&&o.length===1&&o[0]==="stops"&&c.push("stops");let d=Math.min(.34*h,10*s);c.forEach((u,f)=>{let _=.16*h+f*d/c.length,x=_+d/c.length;n.tube(mt(r,l,_),mt(r,l,x),1.25*s,pt[u])}),o.includes("spring")&&this.coil(r,a,c.length>0?1.7:1.1)}coil(t,i,r){let{solids:a,u:n}=this,s=Ri(La(i,t)),o=en(s),l=oa(s,o),h=7,c=8,d=[t];for(let u=0;u<=h*c;++u){let f=2*Math.PI*u/c;d.push(mt(mt(Qa(t,i,.1+.8*u/(h*c)),o,r*n*Math.cos(f)),l,r*n*Math.sin(f)))}a.line([...d,i],.2*n,pt.spring)}cable(t,i,[r,a]){this.solids.tube(r,a,.22*this.u,pt.cable)}spring({type:t},i,[r,a,n]){let{solids:s,u:o}=this,l=Qa(r,a,.5),h=Ri(n);if(t==="torsion")for(let c=0;c<3;++c)s.arc(mt(l,h,(c-1)*.7*o),h,(1.9+.15*c)*o,.96,.6*o,pt.spring,!1);if(t==="centring")for(let c of[h,en(h)])s.arc(l,c,1.9*o,1,.6*o,pt.spring,!1);if(t==="bushing"){for(let c of[-.9,0,.9])this.barrel(mt(l,h,c*o),h,.28,1.7,pt.spring);s.tube(r,a,.3*o,pt.spring)}}drive({type:t},i,[r,a,n,s]){let{solids:o,u:l}=this,h=Qa(r,a,.5),c=Ri(s),d=tr(n,c),u=this.largest.drive>0?d/this.largest.drive:0,f=d<0?-1:1;if(t==="turns")o.arc(h,c,3*l,f*(.35+.5*Math.abs(u)),.8*l,pt.drive);else{let _=mt(h,en(c),2*l);o.arrow(mt(_,c,-f*2*l),mt(_,c,f*(2+5*Math.abs(u))*l),1.5*l,pt.drive)}}gear({type:t},i,[r,a,n,s]){let{solids:o,u:l}=this,h=Ri(n),c=en(h),d=oa(h,c),u=s[1]>.5,f=10,_=La(a,r),x=Math.max(1,Math.round(ir(_)/(3*l)));for(let p=0;p<x;++p)o.tube(mt(r,_,(p+.25)/x),mt(r,_,(p+.75)/x),.16*l,pt.gear);if(!u){this.barrel(r,h,3.2,.5,pt.gear);return}this.barrel(r,h,.3,2,pt.gear);for(let p=0;p<f;++p){let m=mt([0,0,0].map((w,R)=>c[R]*Math.cos(2*Math.PI*p/f)),d,Math.sin(2*Math.PI*p/f));o.tube(mt(r,m,1.9*l),mt(r,m,2.6*l),.32*l,pt.gear)}}force({type:t},i,[r,,a,n]){let{solids:s,u:o,largest:l}=this,h=ir(a),c=ir(n);if(l.force>0&&h>.001*l.force){let d=Ri(a);s.arrow(mt(r,d,-(4+16*(h/l.force))*o),r,1.9*o,pt.force)}l.torque>0&&c>.001*l.torque&&s.arc(r,Ri(n),3.4*o,.3+.5*c/l.torque,.8*o,pt.force),l.force===0&&l.torque===0&&s.ball(r,.8*o,pt.force)}setTrack(t){this.track=this.marks.byName.has(t)?t:"",this.way=this.track?this.marks.way(this.marks.byName.get(this.track)):[]}showTrack(t){let{tracks:i,u:r}=this;if(i.begin(),this.track){let a=this.marks.vector(this.marks.byName.get(this.track),0,t);i.line([...this.way.slice(0,t.k+1),a],.34*r,pt.track),i.line([a,...this.way.slice(t.k+1)],.14*r,pt.track),i.ball(a,.9*r,pt.track)}i.finish()}names(t,i){let r=this.marks.moment(t,i);return this.marks.list.flatMap((a,n)=>a.kind==="gear"||a.kind!=="body"&&!this.on[this.layerOf[a.kind]]?[]:[{text:a.name,kind:a.kind,place:Qa(this.marks.vector(n,0,r),this.marks.vector(n,1,r),.5)}])}};var IE={x:[1,0,0],y:[0,1,0],z:[0,0,1]},UE=.5,Fm=.47,OE=30,FE=3e5,bl=class{constructor(t,i){if(this.place=t,this.run=i,this.smooth=!0,this.time=0,this.controls=null,!i.grains&&!i.bodies&&!i.marks)return;let r=document.createElement("canvas"),a=r.getContext("webgl2",{alpha:!1,antialias:!1,powerPreference:"high-performance"});this.renderer=new Rm({canvas:r,context:a}),this.renderer.setClearColor(15659508),this.ratio=Math.min(window.devicePixelRatio||1,2),t.append(this.renderer.domElement),this.inSoftware=this.drawsInSoftware(),this.paints=this.inSoftware&&i.grains?.count<FE,this.scene=new Jp,this.camera=new lr(35,1,.01,1e3),this.up=Ri((i.gravity??[0,0,0]).map(n=>-n)),this.camera.up.set(...this.up),this.scene.add(new pm(16777215,1)),i.grains&&(this.grains=new xl(i.grains)),i.bodies&&(this.bodies=new tn(i.bodies,i.bodyNames)),i.marks&&(this.marks=new Ml(i.marks));for(let n of this.parts())this.scene.add(n.object);this.box=new Ca;for(let n of[i.grains,i.bodies,i.marks])n&&(this.box.expandByPoint(new X(...n.view.low)),this.box.expandByPoint(new X(...n.view.high)));this.size=this.box.getSize(new X).length()||1,this.overlay=new yl(t,this),this.addGround(),this.orbit=new Qc(this.camera,this.renderer.domElement),this.orbit.addEventListener("change",()=>this.wish()),this.look(-65,24),this.overlay.show(),this.clip={axis:"",share:.5,flip:!1},new ResizeObserver(()=>this.resize()).observe(t),this.resize()}drawsInSoftware(){let t=this.renderer.getContext(),i=t.getExtension("WEBGL_debug_renderer_info"),r=t.getParameter(i?i.UNMASKED_RENDERER_WEBGL:t.RENDERER);return/swiftshader|llvmpipe|softpipe|software|basic render/i.test(r)}parts(){return[this.grains,this.bodies].filter(Boolean)}async loadFirst(){for(let t of this.parts())await t.loadFirst();if(await this.marks?.load(),this.marks){let t=new Ca;for(let i of[this.run.bodies,this.run.marks])if(i)for(let r of["low","high"])t.expandByPoint(new X(...i.view[r]));this.mechanism=t,this.symbols=new El(this.marks,this.bodies,this.run.bodyNames,t.getSize(new X).length()||this.size,this.up),this.scene.add(this.symbols.object)}this.hasFrames=!0}async loadNext(){let t=!1;for(let i of this.parts())t=await i.loadNext()||t;return t}loaded(){let t=this.parts();return t.length===0?1:Math.min(...t.map(i=>i.frames.length/i.times.length))}addForces(t){this.scene&&(this.arrows=new gl(t,this.run.bodyNames,this.size,this.marks),this.scene.add(this.arrows.object))}addGround(){let t=10**Math.floor(Math.log10(this.size/8));this.square=[1,2,5,10].map(l=>l*t).find(l=>this.size/l<16)??10*t;let i=2*Math.ceil(this.size/this.square/2),r=this.box.getCenter(new X),a=l=>Math.round(l/this.square)*this.square,n=(l=12963027)=>new mm(i*this.square,i,8951459,l).rotateX(Math.PI/2),s=this.run.planes??[];if(this.slope=0,s.forEach(({point:l,normal:h},c)=>{let d=new X(...h),u=n(10721920),f=r.clone().addScaledVector(d,-d.dot(r.clone().sub(new X(...l)))),_=new Er().setFromUnitVectors(new X(0,0,1),d),x=new Ti().add(u,this.ground(.5*i*this.square,_));x.applyQuaternion(_),x.position.copy(f),this.scene.add(x),c===0&&(this.slope=Math.acos(Math.min(1,Math.abs(tr(Ri(h),this.up)))))}),s.length>0)return;this.slope=Math.acos(Math.min(1,this.up[2]));let o=n();o.position.set(a(r.x),a(r.y),this.box.min.z),this.scene.add(o)}ground(t,i){let r=t,a=new X(...this.up).applyQuaternion(i.clone().invert()).toArray(),n=[[-r,-r,0],[r,-r,0],[r,r,0],[-r,r,0]],s=n.map(d=>tr(d,a)),o=Math.min(...s),l=n.map((d,u)=>mt(d,a,o-s[u])),h=new Ti,c=(d,u)=>{let f=new pi;f.setAttribute("position",new Ai(d.flat(),3));let _=new Di(f,new Xc({color:u,side:dl,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}));_.renderOrder=-1,h.add(_)};return c([0,1,2,0,2,3].map(d=>n[d]),14274484),Math.max(...s)-o>.001*r&&a[2]>.1&&n.forEach((d,u)=>c([d,n[(u+1)%4],l[(u+1)%4],d,l[(u+1)%4],l[u]],u%2?11905416:12892310)),h}level(){let t=Ri(mt([1,0,0],this.up,-this.up[0]),[0,1,0]);return{x:t,y:oa(this.up,t),z:this.up}}look(t,i,r=1,a=null){if(!this.scene)return;let n=t*Math.PI/180,s=i*Math.PI/180,{x:o,y:l,z:h}=this.level(),c=[0,1,2].map(f=>Math.cos(s)*Math.cos(n)*o[f]+Math.cos(s)*Math.sin(n)*l[f]+Math.sin(s)*h[f]),d=a?new X(...a):this.box.getCenter(new X),u=Math.tan(this.camera.fov*Math.PI/360)*Math.min(1,this.camera.aspect);this.camera.position.copy(d).addScaledVector(new X(...c),Fm*this.size/u/r),this.camera.near=this.size/500/Math.max(1,r),this.camera.far=this.size*20,this.camera.updateProjectionMatrix(),this.orbit.target.copy(d),this.orbit.update(),this.wish()}lookAtMechanism(t,i){let r=this.mechanism??this.box;this.look(t,i,this.size/(r.getSize(new X).length()||this.size),r.getCenter(new X).toArray())}eye(){let t=this.camera.position.clone().sub(this.orbit.target),{x:i,y:r,z:a}=this.level(),n=t.toArray(),s=t.length(),o=Math.tan(this.camera.fov*Math.PI/360)*Math.min(1,this.camera.aspect);return{azimuth:Math.atan2(tr(n,r),tr(n,i))*180/Math.PI,elevation:Math.asin(Math.min(1,Math.max(-1,tr(n,a)/s)))*180/Math.PI,zoom:Fm*this.size/o/s,at:this.orbit.target.toArray()}}setClip(t){if(!this.scene)return;Object.assign(this.clip,t);let{axis:i,share:r,flip:a}=this.clip,n=a?1:-1,s=(IE[i]??[0,0,0]).map(l=>l*n),o=i?this.box.min[i]+r*(this.box.max[i]-this.box.min[i]):0;this.grains?.material.uniforms.uClip.value.set(...s,i?n*o:1),this.bodies?.uniforms.uClip.value.set(...s,i&&this.clip.bodies?n*o:1e30),this.clipAt=o,this.wish()}setTime(t){this.time=t,this.scene&&(this.grainFrame=this.grains?.show(t,this.smooth),this.bodies?.show(t,this.smooth),this.symbols?.show(t,this.smooth),this.arrows?.show(t,i=>this.bodies?.centre(i)??null,this.smooth),this.wish())}resize(){let{clientWidth:t,clientHeight:i}=this.place;!this.scene||!(t>0&&i>0)||(this.camera.aspect=t/i,this.camera.updateProjectionMatrix(),this.renderer.setPixelRatio(this.ratio),this.renderer.setSize(t,i),this.grains&&(this.grains.material.uniforms.uPixels.value=this.renderer.domElement.height),this.wish())}suitRate(t,i){if(!this.scene)return;this.symbols?.solids.showGhosts(!i||!this.inSoftware);let r=Math.min(window.devicePixelRatio||1,2),a=this.ratio;i?t>0&&t<OE-2&&(a=Math.max(UE,.85*a)):a=r,a!==this.ratio&&(this.ratio=a,this.resize())}wish(){this.wished||!this.scene||(this.wished=!0,requestAnimationFrame(()=>this.draw()))}draw(){if(this.wished=!1,!this.scene||!this.hasFrames)return;this.camera.updateMatrixWorld();let{width:t,height:i}=this.renderer.domElement;this.grains?.paint(this.paints,this.camera,t,i),this.renderer.render(this.scene,this.camera),this.overlay.show()}};function km(e){document.body.dataset.state="failed";let t=document.getElementById("footfall-fault");t.hidden=!1,t.textContent=`This run cannot be shown: ${e.message}. The page needs a browser of 2023 or later with WebGL 2.`,console.error(e)}var kE=160,BE=()=>new Promise(e=>setTimeout(e,0));async function zE(){let e=document.createElement("style");e.textContent=wu+Tu+Au,document.head.append(e);let t=Pu(),i=new bl(document.getElementById("footfall-stage"),t);await i.loadFirst();let r=t.history?await Lu(t):{time:new Float64Array,columns:new Map};i.addForces(r);let a=[r.time,t.grains?.times??[],t.bodies?.times??[],t.marks?.times??[]].filter(d=>d.length>0),n=new Ks({start:Math.min(...a.map(d=>d[0])),end:Math.max(...a.map(d=>d[d.length-1])),marks:t.grains?.times??t.bodies?.times??t.marks?.times??r.time}),s=t.history?new mo(document.getElementById("footfall-plots"),r,t.shown,d=>n.seek(d)):null,o=new Ir(t,i,n);i.controls=o;let l=-1/0;n.onTime=d=>{i.setTime(d);let u=performance.now();n.playing&&u-l<kE||(l=u,s?.showTime(d),o.showTime(d))},n.onStopped=()=>n.seek(n.time),n.seek(n.start);let h=Ol();document.body.classList.toggle("picture",h.picture==="1"),document.body.classList.toggle("still",!t.history),i.resize(),o.follow(h),window.addEventListener("hashchange",()=>o.follow(Ol())),i.draw(),document.body.dataset.firstFrame=Math.round(performance.now()),document.body.dataset.state="loading";for(let d=!0;d;)d=await i.loadNext(),o.showLoaded(),await BE();n.seek(h.t!==void 0?Number(h.t)||n.start:n.time),document.body.dataset.loaded=Math.round(performance.now()),document.body.dataset.state="ready";let c=d=>(n.seek(d),o.showCaption(n.time,window.footfall.slow),i.draw(),n.time);window.footfall={run:t,stage:i,player:n,plots:s,controls:o,picture:c},h.picture==="1"&&c(n.time)}window.addEventListener("error",e=>km(e.error??new Error(e.message)));zE().catch(km);})();
