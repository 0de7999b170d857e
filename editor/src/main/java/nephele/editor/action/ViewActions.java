package nephele.editor.action;

import java.util.List;
import java.util.Locale;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.action.EditorAction.Subject;
import nephele.editor.document.Document;
import nephele.editor.document.EntityBounds;
import nephele.editor.document.Grid;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneLayout;
import nephele.editor.pane.PaneLayout.Arrangement;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.pane.PlanCamera;
import nephele.editor.pane.ViewMode;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.EditorSetting.Theme;
import nephele.editor.session.EditorSettings;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.level.Language;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** Panes, cameras, view modes, the grid, and the look of the window. */
final class ViewActions {
    private static final Words FRAME = Words.of("Focus", "Focalizar", "Focar");

    static final List<EditorAction> ALL = List.of(
            mode("lit", Words.of("Lit", "Iluminado", "Iluminado"), ViewMode.LIT, "Alt+1"),
            mode("unlit", Words.of("Unlit", "Sem luz", "Sem luz"), ViewMode.UNLIT, "Alt+2"),
            mode(
                    "portalable",
                    Words.of("Portalable", "Aceita portais", "Aceita portais"),
                    ViewMode.PORTALABLE,
                    "Alt+3"),
            mode("collision", Words.of("Collision", "Colisão", "Colisão"), ViewMode.COLLISION, "Alt+4"),
            mode("wireframe", Words.of("Wireframe", "Aramado", "Estrutura de arame"), ViewMode.WIREFRAME, "Alt+5"),
            panes("one-pane", Words.of("One Pane", "Um painel", "Um painel"), Arrangement.ONE, "Ctrl+1"),
            panes("two-panes", Words.of("Two Panes", "Dois painéis", "Dois painéis"), Arrangement.TWO, "Ctrl+2"),
            panes("four-panes", Words.of("Four Panes", "Quatro painéis", "Quatro painéis"), Arrangement.FOUR, "Ctrl+4"),
            EditorAction.of(
                            "maximise",
                            Words.of("Maximise Pane", "Maximizar painel", "Maximizar painel"),
                            Menu.VIEW,
                            List.of("Shift+Space"),
                            call -> call.session().panes(PaneLayout::maximiseToggled))
                    .chosenWhen(session -> session.panes().isMaximised()),
            EditorAction.of(
                    "cycle-view",
                    Words.of("Next View", "Próxima vista", "Vista seguinte"),
                    Menu.VIEW,
                    List.of("Tab"),
                    call -> call.session().panes(PaneLayout::cycled)),
            EditorAction.of("focus", FRAME, Menu.VIEW, List.of("F"), ViewActions::focus),
            EditorAction.of(
                            "camera",
                            Words.of("Go to Coordinates…", "Ir para coordenadas…", "Ir para coordenadas…"),
                            Menu.VIEW,
                            List.of("Ctrl+Alt+G"),
                            ViewActions::camera)
                    .taking("at", "yaw", "pitch"),
            EditorAction.of(
                    "grid-finer",
                    Words.of("Finer Grid", "Grade mais fina", "Grelha mais fina"),
                    Menu.VIEW,
                    List.of("OpenBracket"),
                    call -> call.session().grid(call.session().grid().finer())),
            EditorAction.of(
                    "grid-coarser",
                    Words.of("Coarser Grid", "Grade mais larga", "Grelha mais larga"),
                    Menu.VIEW,
                    List.of("CloseBracket"),
                    call -> call.session().grid(call.session().grid().coarser())),
            EditorAction.of(
                            "grid",
                            Words.of("Set the Grid", "Definir a grade", "Definir a grelha"),
                            Menu.VIEW,
                            List.of(),
                            call -> call.session()
                                    .grid(new Grid(call.number(
                                            "metres",
                                            Grid.FINEST_METRES,
                                            Grid.COARSEST_METRES,
                                            call.session().grid().stepMetres()))))
                    .taking("metres"),
            EditorAction.of(
                            "guide-lines",
                            Words.of("Guide Lines", "Linhas de guia", "Linhas de guia"),
                            Menu.VIEW,
                            List.of("Shift+G"),
                            call -> call.session().settings(guideLines(call.session())))
                    .chosenWhen(session -> session.settings().get(EditorSetting.GUIDE_LINES)),
            EditorAction.of(
                            "bake-light",
                            Words.of("Bake Light", "Pré-calcular a luz", "Pré-calcular a luz"),
                            Menu.VIEW,
                            List.of("Shift+B"),
                            call -> call.session().bakesLight(!call.session().bakesLight()))
                    .chosenWhen(EditorSession::bakesLight),
            setting(
                    "theme-light",
                    Words.of("Light Theme", "Tema claro", "Tema claro"),
                    EditorSetting.THEME,
                    Theme.LIGHT),
            setting(
                    "theme-dark",
                    Words.of("Dark Theme", "Tema escuro", "Tema escuro"),
                    EditorSetting.THEME,
                    Theme.DARK),
            language(Language.EN),
            language(Language.PT_BR),
            language(Language.PT_PT));
    /** The parts of the window that ask or report something; a script has none of them. */
    static final List<EditorAction> OF_WINDOW = List.of(
            part("turn-by", Words.of("Turn by…", "Girar em…", "Rodar em…"), Menu.EDIT, List.of("Ctrl+Alt+R"))
                    .when(EditActions::hasSelection),
            part("settings", Words.of("Settings…", "Configurações…", "Definições…"), Menu.EDIT, List.of("Ctrl+Comma")),
            part(
                    "guide",
                    Words.of("Guide: Your First Room", "Guia: sua primeira sala", "Guia: a tua primeira sala"),
                    Menu.HELP,
                    List.of("F1")),
            part(
                    "palette",
                    Words.of("Search Commands…", "Buscar comandos…", "Procurar comandos…"),
                    Menu.HELP,
                    List.of("Ctrl+K", "Ctrl+Shift+P")),
            part("keys", Words.of("Keys…", "Teclas…", "Teclas…"), Menu.HELP, List.of()));

    private ViewActions() {}

    private static EditorAction mode(String id, Words title, ViewMode mode, String key) {
        return EditorAction.of(id, title, Menu.VIEW, List.of(key), call -> call.session()
                        .panes(panes ->
                                panes.with(panes.active(), panes.activeView().with(mode))))
                .chosenWhen(session -> session.panes().activeView().mode() == mode);
    }

    private static EditorAction panes(String id, Words title, Arrangement arrangement, String key) {
        return EditorAction.of(id, title, Menu.VIEW, List.of(key), call -> call.session()
                        .panes(panes -> panes.with(arrangement)))
                .chosenWhen(session -> session.panes().arrangement() == arrangement);
    }

    private static EditorSettings guideLines(EditorSession session) {
        return session.settings()
                .with(EditorSetting.GUIDE_LINES, !session.settings().get(EditorSetting.GUIDE_LINES));
    }

    private static <T> EditorAction setting(String id, Words title, EditorSetting<T> setting, T value) {
        return EditorAction.of(id, title, Menu.WINDOW, List.of(), call -> call.session()
                        .settings(call.session().settings().with(setting, value)))
                .chosenWhen(session -> session.settings().get(setting) == value);
    }

    private static EditorAction language(Language language) {
        String id = "language-" + language.name().toLowerCase(Locale.ROOT).replace('_', '-');
        return setting(id, Words.same(language.title()), EditorSetting.LANGUAGE, language);
    }

    /** Shows what is selected, or the whole level, in all panes. */
    private static void focus(ActionCall call) {
        EditorSession session = call.session();
        Document document = session.document();
        List<EntityRef> refs = document.selection().entities().isEmpty()
                ? Entities.LEVEL.all(document.level())
                : document.selection().entities();
        Aabb box = Aabb.EMPTY;
        for (EntityRef ref : refs) {
            box = box.union(Entities.LEVEL
                    .find(document.level(), ref)
                    .map(EntityBounds::of)
                    .orElse(Aabb.EMPTY));
        }
        if (!box.isEmpty()) {
            Aabb all = box;
            session.panes(panes -> focused(panes, all, session.viewport()));
        }
    }

    private static PaneLayout focused(PaneLayout panes, Aabb box, PaneSize viewport) {
        PaneLayout result = panes;
        for (PaneLayout.PaneRectangle place : panes.rectangles(viewport, PaneLayout.GAP_PIXELS)) {
            PaneView view = result.views().get(place.index());
            PaneView focused = new PaneView(
                    view.kind(),
                    PerspectiveCamera.focus(view.perspective(), box, place.size()),
                    PlanCamera.focus(view.plan(), box, place.size()),
                    view.mode());
            result = result.with(place.index(), focused);
        }
        return result;
    }

    private static void camera(ActionCall call) throws EditorRefusal {
        if (!call.isGiven("at", "coordinates")) {
            return;
        }
        Vec3 eye = call.vector("at");
        double yaw = call.number("yaw", -ActionCall.MOST, ActionCall.MOST, 0);
        double pitch = call.number("pitch", -90, 90, 0);
        call.session()
                .panes(panes -> panes.each(view -> new PaneView(
                        view.kind(),
                        new PerspectiveCamera(
                                eye, yaw, pitch, view.perspective().verticalFovDegrees()),
                        PlanCamera.at(view.plan(), eye),
                        view.mode())));
    }

    private static EditorAction part(String id, Words title, Menu menu, List<String> keys) {
        return EditorAction.of(id, title, menu, keys, call -> call.ui().show(id))
                .changing(Subject.WINDOW);
    }
}
