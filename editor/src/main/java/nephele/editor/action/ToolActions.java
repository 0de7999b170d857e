package nephele.editor.action;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
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
import nephele.editor.tool.ToolEntry;
import nephele.editor.tool.ToolOptions.Snapping;
import nephele.editor.tool.clip.ClipTool;

/** Taking a tool, and the options of tools: what places snap to, the shape of new brushes, what stays after a cut. */
final class ToolActions {
    private static final Words ON = Words.of("%s: on", "%s: ligado", "%s: ligado");
    private static final Words OFF = Words.of("%s: off", "%s: desligado", "%s: desligado");
    private static final int STAIRS = 8;
    private static final int ARCH_SEGMENTS = 12;
    private static final int CYLINDER_SIDES = 16;
    private static final double WALL_METRES = 0.5;

    /** The options, in the order of the menus. */
    static final List<EditorAction> OPTIONS = options();
    /** What takes a tool, and what stops its drag. */
    static final List<EditorAction> TOOLS = tools();

    private ToolActions() {}

    private static List<EditorAction> tools() {
        List<EditorAction> actions = new ArrayList<>();
        for (ToolEntry entry : Tools.ALL) {
            List<String> keys = entry.key().isEmpty() ? List.of() : List.of(entry.key());
            actions.add(EditorAction.of("tool-" + entry.id(), entry.title(), Menu.TOOL, keys, call -> call.session()
                            .use(entry))
                    .chosenWhen(session -> session.toolEntry().id().equals(entry.id())));
        }
        actions.add(EditorAction.of(
                "cancel",
                Words.of("Cancel the Drag", "Cancelar o arraste", "Cancelar o arrasto"),
                Menu.TOOL,
                List.of("Escape"),
                call -> {
                    call.session().tool().cancel();
                    call.session().proving().dismiss();
                }));
        actions.add(EditorAction.of(
                        "clip-keep",
                        Words.of("Clip: Keep Another Part", "Cortar: manter outra parte", "Cortar: manter outra parte"),
                        Menu.TOOL,
                        List.of("Shift+C"),
                        call -> keepAnotherPart(call.session()))
                .when(session -> clip(session).isPresent()));
        return List.copyOf(actions);
    }

    private static void keepAnotherPart(EditorSession session) {
        clip(session).ifPresent(clip -> {
            clip.cycle();
            session.tell(SessionChange.VIEW);
        });
    }

    private static List<EditorAction> options() {
        List<EditorAction> all = new ArrayList<>();
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

    private static EditorAction toggled(
            String id, Words title, Menu menu, Consumer<EditorSession> chooses, Predicate<EditorSession> isOn) {
        return EditorAction.of(id, title, menu, List.of(), call -> {
                    chooses.accept(call.session());
                    call.session().tell(SessionChange.VIEW);
                })
                .chosenWhen(isOn);
    }

    private static void snap(List<EditorAction> all, Words title, Snapping target, String digit) {
        Consumer<EditorSession> toggle = session -> {
            Set<Snapping> targets = session.options().snapping();
            boolean isOn = !targets.remove(target) && targets.add(target);
            session.status((isOn ? ON : OFF).with(title));
        };
        String id = "snap-" + target.name().toLowerCase(Locale.ROOT);
        all.add(toggled(id, title, Menu.VIEW, toggle, session -> session.options()
                        .snapping()
                        .contains(target))
                .keyed("Alt+Shift+" + digit));
    }

    private static void shape(List<EditorAction> all, String id, Words title, ShapeOptions shape) {
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

    private static void keep(List<EditorAction> all, String id, Words title, Keep keep) {
        all.add(toggled(
                        id,
                        title,
                        Menu.BRUSH,
                        session -> clip(session).ifPresent(tool -> tool.keep(keep)),
                        session -> clip(session)
                                .filter(tool -> tool.keep() == keep)
                                .isPresent())
                .when(session -> clip(session).isPresent()));
    }
}
