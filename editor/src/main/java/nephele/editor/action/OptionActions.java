package nephele.editor.action;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.brush.BrushClip.Keep;
import nephele.editor.brush.ShapeOptions;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionChange;
import nephele.editor.session.Tools;
import nephele.editor.text.Words;
import nephele.editor.tool.ToolOptions.Snapping;
import nephele.editor.tool.clip.ClipTool;

/** Options of the tools: what places snap to, the shape of new brushes, what stays after a cut. */
final class OptionActions {
    private static final Words ON = Words.of("%s: on", "%s: ligado", "%s: ligado");
    private static final Words OFF = Words.of("%s: off", "%s: desligado", "%s: desligado");
    private static final int STAIRS = 8;
    private static final int ARCH_SEGMENTS = 12;
    private static final int CYLINDER_SIDES = 16;
    private static final double WALL_METRES = 0.5;
    private static final List<Option> OPTIONS = options();
    static final List<EditorAction> ALL = OPTIONS.stream().map(Option::action).toList();
    /** Tells by action which options are on. */
    static final Map<String, Predicate<EditorSession>> CHOSEN = chosen();

    /** An option that is on or off. */
    private record Option(EditorAction action, Predicate<EditorSession> isOn) {}

    private OptionActions() {}

    private static Map<String, Predicate<EditorSession>> chosen() {
        Map<String, Predicate<EditorSession>> states = new LinkedHashMap<>();
        OPTIONS.forEach(option -> states.put(option.action().id(), option.isOn()));
        return Map.copyOf(states);
    }

    private static List<Option> options() {
        List<Option> all = new ArrayList<>();
        snap(all, Words.of("Snap to Grid", "Encaixar na grade", "Ajustar à grelha"), Snapping.GRID, "1");
        snap(all, Words.of("Snap to Vertices", "Encaixar em vértices", "Ajustar a vértices"), Snapping.VERTEX, "2");
        snap(
                all,
                Words.of("Snap to Surfaces", "Encaixar em superfícies", "Ajustar a superfícies"),
                Snapping.SURFACE,
                "3");
        snap(
                all,
                Words.of("Snap onto the Grid", "Encaixar sobre a grade", "Ajustar sobre a grelha"),
                Snapping.ABSOLUTE,
                "4");
        shape(all, "shape-box", Words.of("Box", "Caixa", "Caixa"), new ShapeOptions.Box());
        shape(all, "shape-wedge", Words.of("Wedge", "Cunha", "Cunha"), new ShapeOptions.Wedge(null));
        shape(all, "shape-stairs", Words.of("Stairs", "Escada", "Escada"), new ShapeOptions.Stairs(null, STAIRS));
        shape(all, "shape-arch", Words.of("Arch", "Arco", "Arco"), new ShapeOptions.Arch(ARCH_SEGMENTS, WALL_METRES));
        shape(
                all,
                "shape-cylinder",
                Words.of("Cylinder", "Cilindro", "Cilindro"),
                new ShapeOptions.Cylinder(CYLINDER_SIDES));
        shape(all, "shape-room", Words.of("Room", "Sala", "Sala"), new ShapeOptions.Room(WALL_METRES));
        keep(
                all,
                "keep-behind",
                Words.of("Keep the Part Behind", "Manter a parte de trás", "Manter a parte de trás"),
                Keep.BEHIND);
        keep(
                all,
                "keep-front",
                Words.of("Keep the Part in Front", "Manter a parte da frente", "Manter a parte da frente"),
                Keep.IN_FRONT);
        keep(
                all,
                "keep-both",
                Words.of("Keep Both Parts", "Manter as duas partes", "Manter ambas as partes"),
                Keep.BOTH);
        all.add(toggled(
                "new-portalable",
                Words.of("Make Portalable", "Tornar apto a portais", "Tornar apto a portais"),
                Menu.BRUSH,
                session -> session.options().portalable(!session.options().isPortalable()),
                session -> session.options().isPortalable()));
        all.add(toggled(
                "texture-lock",
                Words.of("Lock Textures to Brushes", "Prender texturas aos blocos", "Prender texturas aos blocos"),
                Menu.BRUSH,
                session -> session.options().textureLocked(!session.options().isTextureLocked()),
                session -> session.options().isTextureLocked()));
        return List.copyOf(all);
    }

    private static Option toggled(
            String id, Words title, Menu menu, Consumer<EditorSession> chooses, Predicate<EditorSession> isOn) {
        EditorAction action = EditorAction.of(id, title, menu, List.of(), call -> {
            chooses.accept(call.session());
            call.session().tell(SessionChange.VIEW);
        });
        return new Option(action, isOn);
    }

    private static void snap(List<Option> all, Words title, Snapping target, String digit) {
        Consumer<EditorSession> toggle = session -> {
            Set<Snapping> targets = session.options().snapping();
            boolean isOn = !targets.remove(target) && targets.add(target);
            session.status((isOn ? ON : OFF).with(title));
        };
        Option option = toggled(
                "snap-" + target.name().toLowerCase(Locale.ROOT), title, Menu.VIEW, toggle, session -> session.options()
                        .snapping()
                        .contains(target));
        all.add(new Option(option.action().keyed("Alt+Shift+" + digit), option.isOn()));
    }

    private static void shape(List<Option> all, String id, Words title, ShapeOptions shape) {
        Consumer<EditorSession> choose = session -> {
            session.options().shape(shape);
            if (!session.toolEntry().id().equals("brush")) {
                Tools.named("brush").ifPresent(session::use);
            }
        };
        all.add(toggled(
                id,
                title,
                Menu.BRUSH,
                choose,
                session -> session.options().shape().getClass() == shape.getClass()));
    }

    private static Optional<ClipTool> clip(EditorSession session) {
        return Optional.of(session.tool()).filter(ClipTool.class::isInstance).map(ClipTool.class::cast);
    }

    private static void keep(List<Option> all, String id, Words title, Keep keep) {
        Option option = toggled(
                id,
                title,
                Menu.BRUSH,
                session -> clip(session).ifPresent(tool -> tool.keep(keep)),
                session -> clip(session).filter(tool -> tool.keep() == keep).isPresent());
        all.add(new Option(option.action().when(session -> clip(session).isPresent()), option.isOn()));
    }
}
