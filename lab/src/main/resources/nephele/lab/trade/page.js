for (const viewer of document.querySelectorAll(".viewer")) {
  const shown = viewer.querySelector(".over");
  const tag = viewer.querySelector(".tag.right");
  const wipe = viewer.querySelector(".wipe");
  const settings = [...viewer.querySelectorAll("button[data-shown]")];
  const kinds = [...viewer.querySelectorAll("button[data-kind]")];
  let setting = settings.find((button) => button.getAttribute("aria-pressed") === "true");
  let kind = "shown";
  const show = () => {
    shown.src = viewer.querySelector(`img[data-of="${setting.dataset.shown}"][data-is="${kind}"]`).src;
    tag.textContent = setting.textContent + (kind === "flip" ? ": where it differs" : "");
    for (const button of settings) button.setAttribute("aria-pressed", String(button === setting));
    for (const button of kinds) button.setAttribute("aria-pressed", String(button.dataset.kind === kind));
  };
  settings.forEach((button) => button.addEventListener("click", () => { setting = button; show(); }));
  kinds.forEach((button) => button.addEventListener("click", () => { kind = button.dataset.kind; show(); }));
  viewer.querySelector("input").addEventListener("input", (event) => wipe.style.setProperty("--cut", event.target.value + "%"));
  show();
}
