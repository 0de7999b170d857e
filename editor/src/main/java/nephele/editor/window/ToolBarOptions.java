package nephele.editor.window;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** The actions of the option bar: those of the view, which are always shown, and those of each tool. */
final class ToolBarOptions {
    /** Groups of the view, in order; the step of the grid is chosen between the last two. */
    static final List<List<String>> VIEW = List.of(
            List.of("lit", "unlit", "portalable", "collision", "wireframe"),
            List.of("one-pane", "two-panes", "four-panes"),
            List.of("snap-grid", "snap-vertex", "snap-surface", "snap-absolute"));

    /** Actions that do something at once instead of choosing a state. */
    static final List<String> MOMENTARY = List.of(
            "texture-pick",
            "texture-fit",
            "texture-left",
            "texture-centre",
            "texture-right",
            "texture-top",
            "texture-middle",
            "texture-bottom",
            "texture-reset",
            "terrain-smaller",
            "terrain-larger",
            "terrain-weaker",
            "terrain-stronger");

    private static final List<String> TEXTURES =
            MOMENTARY.stream().filter(id -> id.startsWith("texture-")).toList();

    private static final List<String> TEXTURE_LOCK = List.of("texture-lock");

    private static final Map<String, List<String>> OF_TOOL = Map.of(
            "terrain",
            List.of(
                    "terrain-raise",
                    "terrain-lower",
                    "terrain-smooth",
                    "terrain-flatten",
                    "terrain-paint",
                    "terrain-erase",
                    "terrain-smaller",
                    "terrain-larger",
                    "terrain-weaker",
                    "terrain-stronger"),
            "brush",
            List.of(
                    "shape-box",
                    "shape-wedge",
                    "shape-stairs",
                    "shape-arch",
                    "shape-cylinder",
                    "shape-room",
                    "new-portalable"),
            "clip",
            List.of("keep-behind", "keep-front", "keep-both"),
            "paint",
            Stream.concat(TEXTURES.stream(), TEXTURE_LOCK.stream()).toList(),
            "portalable",
            List.of("new-portalable"),
            "select",
            TEXTURE_LOCK,
            "move",
            TEXTURE_LOCK,
            "rotate",
            TEXTURE_LOCK,
            "scale",
            TEXTURE_LOCK);

    private ToolBarOptions() {}

    /** Returns the ids of the actions of a tool, in order. */
    static List<String> of(String tool) {
        return OF_TOOL.getOrDefault(tool, List.of());
    }
}
