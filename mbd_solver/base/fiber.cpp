// Contexts of POSIX. The stack is mapped, so that its pages cost memory only when they are used, and has a page below it that no one
// may touch.

#include "mbd_solver/base/fiber.h"

#include <sys/mman.h>
#include <ucontext.h>
#include <unistd.h>

#include <cstdint>
#include <new>
#include <utility>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

constexpr std::size_t kStack = std::size_t{8} << 20;  // that of a thread [bytes]

}  // namespace

struct Fiber::Contexts {
  Contexts() : guard(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) {
    memory = mmap(nullptr, kStack + guard, PROT_READ | PROT_WRITE,
                  MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    mprotect(memory, guard, PROT_NONE);
  }
  ~Contexts() { munmap(memory, kStack + guard); }

  std::size_t guard;  // [bytes]
  void* memory;
  ucontext_t caller, work;
};

Fiber::Fiber(std::function<void()> work) : work_(std::move(work)), contexts_(std::make_unique<Contexts>()) {
  ucontext_t& context = contexts_->work;
  FOOTFALL_DEMAND(getcontext(&context) == 0);
  context.uc_stack.ss_sp = static_cast<char*>(contexts_->memory) + contexts_->guard;
  context.uc_stack.ss_size = kStack;
  context.uc_link = &contexts_->caller;
  const auto address = reinterpret_cast<std::uintptr_t>(this);
  makecontext(&context, reinterpret_cast<void (*)()>(&Fiber::enter), 2, static_cast<unsigned>(address >> 32),
              static_cast<unsigned>(address & 0xffffffffu));
}

Fiber::~Fiber() = default;

void Fiber::enter(unsigned high, unsigned low) {
  Fiber& self = *reinterpret_cast<Fiber*>((static_cast<std::uintptr_t>(high) << 32) | low);
  try {
    self.work_();
  } catch (...) {
    self.error_ = std::current_exception();
  }
  self.ended_ = true;
}

void Fiber::resume() {
  FOOTFALL_DEMAND(!ended_);
  begun_ = true;
  swapcontext(&contexts_->caller, &contexts_->work);
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void Fiber::pause() { swapcontext(&contexts_->work, &contexts_->caller); }

}  // namespace footfall
