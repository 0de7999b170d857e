package nephele.editor.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.swing.AbstractButton;
import javax.swing.JLabel;
import javax.swing.JMenuBar;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import nephele.editor.action.EditorAction;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.action.EditorCommands;
import nephele.editor.document.EntityBounds;
import nephele.editor.document.Selection;
import nephele.editor.pane.PaneCamera.PanePoint;
import nephele.editor.pane.PaneLayout;
import nephele.editor.pane.PaneLayout.PaneRectangle;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.PlanCamera;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.EditorSetting.Theme;
import nephele.editor.session.EditorSettings;
import nephele.editor.session.Tools;
import nephele.editor.text.Words;
import nephele.editor.tool.ToolEntry;
import nephele.engine.level.Language;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;
import nephele.workshop.prove.editor.CutTexts;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The whole editor without a display: the tests' JVM is headless. */
@Execution(ExecutionMode.SAME_THREAD)
class EditorPanelSwingTest {
    private static final int TOP_PANE = 1;

    private final List<String> ran = new ArrayList<>();
    private EditorSession session;
    private EditorPanel panel;

    @AfterEach
    void close() {
        if (panel != null) {
            panel.close();
        }
    }

    private EditorAction action(String id, Menu menu, Words title, String key) {
        return new EditorAction(
                id,
                title,
                menu,
                List.of(key),
                List.of(),
                any -> true,
                any -> false,
                call -> ran.add(id),
                EditorAction.Subject.SESSION);
    }

    private List<EditorAction> actions() {
        return List.of(
                action("file.open", Menu.FILE, Words.of("Open…", "Abrir…", "Abrir…"), "Ctrl+O"),
                action("file.save", Menu.FILE, Words.of("Save", "Salvar", "Guardar"), "Ctrl+S"),
                action("edit.undo", Menu.EDIT, Words.of("Undo", "Desfazer", "Anular"), "Ctrl+Z"),
                action("edit.redo", Menu.EDIT, Words.of("Redo", "Refazer", "Refazer"), "Ctrl+Shift+Z"),
                action("select.none", Menu.SELECT, Words.of("Nothing", "Nada", "Nada"), "Esc"),
                action("brush.hollow", Menu.BRUSH, Words.of("Hollow", "Esvaziar", "Esvaziar"), "H"),
                action("terrain.raise", Menu.TERRAIN, Words.of("Raise", "Elevar", "Elevar"), "U"),
                action("view.focus", Menu.VIEW, Words.of("Focus", "Enquadrar", "Enquadrar"), "F"),
                action("play.start", Menu.PLAY, Words.of("Play", "Jogar", "Jogar"), "F5"),
                action("prove.check", Menu.PROVE, Words.of("Check", "Verificar", "Verificar"), "F7"),
                action("window.light", Menu.WINDOW, Words.of("Light", "Claro", "Claro"), "F2"),
                action("help.keys", Menu.HELP, Words.of("Keys", "Teclas", "Teclas"), "F1"));
    }

    private static EditorAction taking(ToolEntry tool) {
        List<String> keys = tool.key().isEmpty() ? List.of() : List.of(tool.key());
        return new EditorAction(
                "tool-" + tool.id(),
                tool.title(),
                Menu.TOOL,
                keys,
                List.of(),
                any -> true,
                session -> session.toolEntry() == tool,
                call -> call.session().use(tool),
                EditorAction.Subject.SESSION);
    }

    private static Stream<ToolEntry> tools() {
        List<ToolEntry> tools = new ArrayList<>(Tools.ALL);
        ToolEntry select = Tools.ALL.get(0);
        for (String id : List.of(
                "brush", "extrude", "vertex", "edge", "clip", "rotate", "scale", "paint", "portal", "place", "measure",
                "light", "camera", "texture", "strange")) {
            Words title = Words.same(id);
            tools.add(new ToolEntry(id, title, title, "", select.make()));
        }
        return tools.stream();
    }

    private static EditorSettings settings(Theme theme, int percent, Language language) {
        return EditorSettings.DEFAULT
                .with(EditorSetting.THEME, theme)
                .with(EditorSetting.SCALE_PERCENT, percent)
                .with(EditorSetting.LANGUAGE, language);
    }

    private void open(EditorSettings settings, Dimension size) {
        WindowLook.apply(settings);
        DocumentFile.Opened opened = DocumentFile.open("levels/02-first-shot.json");
        session = new EditorSession(opened.file(), opened.level(), opened.assets(), settings);
        session.document()
                .select(Selection.of(
                        new EntityRef("solids", largest(opened.level()).id())));
        EditorCommands commands = new EditorCommands(
                session,
                new WindowInterface(session),
                Stream.concat(tools().map(EditorPanelSwingTest::taking), actions().stream())
                        .toList());
        JTabbedPane bottom = new JTabbedPane();
        bottom.addTab("Problems", new JLabel("–"));
        bottom.addTab("History", new JLabel("–"));
        EditorSlots slots = new EditorSlots(
                null,
                new JLabel("outliner"),
                new JLabel("inspector"),
                bottom,
                List.of("file.open", "file.save", "edit.undo", "edit.redo", "play.start", "not.there"));
        panel = new EditorPanel(session, commands, slots);
        panel.layOut(size);
    }

    private static Solid largest(Level level) {
        Solid largest = level.solids().get(0);
        for (Solid solid : level.solids()) {
            Vec3 size = size(solid);
            largest = size.length() > size(largest).length() ? solid : largest;
        }
        return largest;
    }

    private static Vec3 size(Solid solid) {
        var box = EntityBounds.of((Record) solid);
        return new Vec3(box.maxX() - box.minX(), box.maxY() - box.minY(), box.maxZ() - box.minZ());
    }

    @ParameterizedTest
    @CsvSource("LIGHT, 100, PT_PT")
    void aLanguageSwitchedLiveCutsNothingOff(Theme theme, int percent, Language language) throws Exception {
        Dimension size = percent > 100 ? new Dimension(1920, 1200) : new Dimension(1280, 800);
        open(settings(theme, percent, language), size);
        BufferedImage picture = panel.picture();
        write(picture, theme + "-" + percent + "-" + language);
        assertEquals(List.of(), CutTexts.in(panel, session));
        JMenuBar bar = find(panel, JMenuBar.class);
        assertEquals(Menu.values().length, bar.getMenuCount());
        assertEquals(Menu.EDIT.title().in(language), bar.getMenu(1).getText());
        for (Language other : Language.values()) {
            session.settings(session.settings().with(EditorSetting.LANGUAGE, other));
            panel.layOut(panel.getSize());
            assertEquals(
                    Menu.TOOL.title().in(other),
                    bar.getMenu(Menu.TOOL.ordinal()).getText());
            assertEquals(List.of(), CutTexts.in(panel, session), other.title());
        }
    }

    private static void write(BufferedImage picture, String name) throws IOException {
        File folder = new File("build/pictures");
        folder.mkdirs();
        ImageIO.write(picture, "png", new File(folder, "editor-" + name + ".png"));
    }

    private static <T extends Component> T find(Container container, Class<T> type) {
        for (Component child : container.getComponents()) {
            if (type.isInstance(child)) {
                return type.cast(child);
            }
            T inner = child instanceof Container deeper ? find(deeper, type) : null;
            if (inner != null) {
                return inner;
            }
        }
        return null;
    }

    private void openSmall() {
        open(settings(Theme.DARK, 100, Language.EN), new Dimension(900, 600));
        panel.viewport().picture();
        PaneView top = session.panes().views().get(TOP_PANE);
        session.panes(layout -> layout.with(TOP_PANE, top.with(PlanCamera.at(top.plan(), selectedCentre()))));
    }

    private void mouse(int id, int button, double x, double y) {
        Component target = panel.viewport().surface().component();
        boolean isHeld = id != MouseEvent.MOUSE_MOVED;
        int held = isHeld ? InputEvent.getMaskForButton(button) : 0;
        target.dispatchEvent(new MouseEvent(
                target, id, 0, held, (int) Math.round(x), (int) Math.round(y), 1, false, isHeld ? button : 0));
    }

    private void drag(int button, double x, double y, double byX, double byY) {
        mouse(MouseEvent.MOUSE_PRESSED, button, x, y);
        mouse(MouseEvent.MOUSE_DRAGGED, button, x + byX / 2, y + byY / 2);
        mouse(MouseEvent.MOUSE_DRAGGED, button, x + byX, y + byY);
    }

    private PaneRectangle place(int pane) {
        return session.panes().rectangles(session.viewport(), PaneLayout.GAP_PIXELS).stream()
                .filter(each -> each.index() == pane)
                .findFirst()
                .orElseThrow();
    }

    /** Returns where a point of the world appears in the viewport. */
    private PanePoint seen(int pane, Vec3 point) {
        PaneRectangle place = place(pane);
        PaneView view = session.panes().views().get(pane);
        PanePoint in = view.camera().project(point, place.size()).orElseThrow();
        return new PanePoint(place.x() + in.x(), place.y() + in.y(), 0);
    }

    private Vec3 selectedCentre() {
        EntityRef ref = session.document().selection().entities().get(0);
        Record solid = Entities.LEVEL.find(session.document().level(), ref).orElseThrow();
        return EntityBounds.of(solid).centre();
    }

    @Test
    void draggingASelectedBrushMovesItAndEscPutsItBack() {
        openSmall();
        Vec3 before = selectedCentre();
        PanePoint at = seen(TOP_PANE, before);
        drag(MouseEvent.BUTTON1, at.x(), at.y(), 60, 0);
        assertNotEquals(before, selectedCentre());
        assertTrue(panel.key(key(KeyEvent.VK_ESCAPE)));
        assertEquals(before, selectedCentre());
        assertEquals(List.of(), ran);
        mouse(MouseEvent.MOUSE_RELEASED, MouseEvent.BUTTON1, at.x(), at.y());
        drag(MouseEvent.BUTTON1, at.x(), at.y(), 60, 0);
        mouse(MouseEvent.MOUSE_RELEASED, MouseEvent.BUTTON1, at.x() + 60, at.y());
        double metres = 60 * session.panes().views().get(TOP_PANE).plan().metresPerPixel();
        assertEquals(
                session.grid().snapped(before.x() + metres), selectedCentre().x(), 0.5);
        assertEquals(TOP_PANE, session.panes().active());
        assertTrue(session.document().isModified());
        assertTrue(EditorWindow.title(session).startsWith("*02-first-shot.json"), EditorWindow.title(session));
    }

    @Test
    void theRightButtonLooksAndPansAndTheSplitterFollowsTheMouse() {
        openSmall();
        PaneView before = session.panes().views().get(0);
        drag(MouseEvent.BUTTON3, 30, 30, 40, 0);
        PaneView looked = session.panes().views().get(0);
        assertEquals(before.perspective().eye(), looked.perspective().eye());
        assertTrue(looked.perspective().yawDegrees() < before.perspective().yawDegrees());
        assertTrue(panel.key(key(KeyEvent.VK_A)), "flight");
        mouse(MouseEvent.MOUSE_RELEASED, MouseEvent.BUTTON3, 70, 30);
        assertFalse(panel.key(key(KeyEvent.VK_A)), "no flight any more");
        PaneRectangle top = place(TOP_PANE);
        drag(MouseEvent.BUTTON3, top.x() + 50, top.y() + 50, 20, 0);
        mouse(MouseEvent.MOUSE_RELEASED, MouseEvent.BUTTON3, top.x() + 70, top.y() + 50);
        double moved = session.panes().views().get(TOP_PANE).plan().centre().x();
        assertEquals(selectedCentre().x() - 20 * before.plan().metresPerPixel(), moved, 1e-9);
        assertEquals(moved, session.panes().views().get(2).plan().centre().x(), 1e-9, "linked");
        drag(MouseEvent.BUTTON1, top.x() - 2, 20, -60, 0);
        mouse(MouseEvent.MOUSE_RELEASED, MouseEvent.BUTTON1, top.x() - 62, 20);
        assertEquals(top.x() - 62, place(TOP_PANE).x(), 3);
    }

    private KeyEvent key(int code) {
        return new KeyEvent(panel, KeyEvent.KEY_PRESSED, 0, 0, code, (char) code);
    }

    @Test
    void keysRunCommandsButNotWhileATextIsWritten() {
        openSmall();
        assertTrue(panel.key(key(KeyEvent.VK_H)));
        assertEquals(List.of("brush.hollow"), ran);
        JTextField text = new JTextField();
        assertTrue(EditorWindow.belongsTo(text, key(KeyEvent.VK_H)));
        assertFalse(EditorWindow.belongsTo(text, key(KeyEvent.VK_F5)));
        assertFalse(EditorWindow.belongsTo(new JLabel(), key(KeyEvent.VK_H)));
        AbstractButton strange = named(panel, "tool-strange");
        strange.doClick();
        assertEquals("strange", session.toolEntry().id());
        assertTrue(strange.isSelected());
        assertEquals("strange", strange.getAccessibleContext().getAccessibleName());
    }

    private static AbstractButton named(Container container, String name) {
        List<AbstractButton> found = new ArrayList<>();
        for (Component child : container.getComponents()) {
            if (child instanceof AbstractButton button && name.equals(button.getName())) {
                found.add(button);
            } else if (child instanceof Container inner && !(inner instanceof AbstractButton)) {
                Optional.ofNullable(named(inner, name)).ifPresent(found::add);
            }
        }
        return found.isEmpty() ? null : found.get(0);
    }

    @Test
    void closingAsksOnlyIfSomethingWouldBeLost() {
        openSmall();
        List<String> asked = new ArrayList<>();
        BiFunction<String, Language, Closing.Choice> never = (level, language) -> {
            asked.add(level);
            return Closing.Choice.CANCEL;
        };
        assertTrue(new Closing(session, never, () -> true).isAllowed());
        session.document().edit(Words.same("x"), level -> level.with(level.materials(), List.of()));
        assertFalse(new Closing(session, never, () -> true).isAllowed());
        assertEquals(List.of("02-first-shot.json"), asked);
        BiFunction<String, Language, Closing.Choice> save = (level, language) -> Closing.Choice.SAVE;
        assertFalse(new Closing(session, save, () -> false).isAllowed(), "a failed save loses nothing");
    }
}
