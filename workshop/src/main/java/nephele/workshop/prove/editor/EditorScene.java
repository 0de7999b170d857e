package nephele.workshop.prove.editor;

import java.awt.Dimension;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JOptionPane;
import javax.swing.JPopupMenu;
import javax.swing.JTabbedPane;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.file.BackupList;
import nephele.editor.file.FileText;
import nephele.editor.file.RecoveryList;
import nephele.editor.file.SessionJournal;
import nephele.editor.panel.GuideStep;
import nephele.editor.panel.PalettePanel;
import nephele.editor.panel.ProblemsPanel;
import nephele.editor.problem.ProblemSearch;
import nephele.editor.proving.PixelExplanation;
import nephele.editor.save.DocumentFile;
import nephele.editor.save.journal.JournalFolder;
import nephele.editor.session.EditorFiles;
import nephele.editor.session.EditorSession;
import nephele.editor.session.FileServices;
import nephele.editor.session.Tools;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.editor.tool.ToolEntry;
import nephele.editor.window.SwingQuestions;
import nephele.editor.window.WaitingLoop;
import nephele.editor.window.WindowText;
import nephele.editor.window.dialog.DialogFrame;
import nephele.editor.window.dialog.ExplanationPanel;
import nephele.editor.window.file.BackupsPanel;
import nephele.editor.window.file.RecoveryPanel;
import nephele.engine.level.Language;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;
import nephele.workshop.prove.process.TemporaryFolder;

/** A part of the editor to take a picture of: the whole window in use, a menu, what a dialogue shows. */
record EditorScene(String name, Making making) {
    private static final Vec3 FLOOR = new Vec3(1, 0, 2);
    private static final Vec3 WALL = new Vec3(-1.5, 2, -5);
    private static final Vec3 BLOCK_TOP = new Vec3(0.5, 1, -1.5);
    /** What is selected while a tool is shown. */
    private static final Map<String, String> SELECTED = Map.of(
            "move", "lights/lamp",
            "rotate", "solids/block",
            "scale", "solids/block",
            "clip", "solids/block",
            "vertex", "solids/block",
            "extrude", "solids/block",
            "select", "portals/left",
            "sun", "environment.sun");

    /** The parts of the window that are dialogues. */
    private static final List<String> PARTS = List.of(
            "palette",
            "add",
            "rename",
            "move",
            "turn-by",
            "scale",
            "set",
            "brush",
            "coordinates",
            "grid",
            "settings",
            "keys");

    /** Prepares the editor. */
    @FunctionalInterface
    interface Making {
        /** Returns the part to show by itself; {@code null} for the whole editor. */
        JComponent show(PicturedEditor editor) throws Exception;
    }

    /** Prepares the whole editor. */
    @FunctionalInterface
    interface Preparation {
        void prepare(PicturedEditor editor) throws Exception;
    }

    static EditorScene whole(String name, Preparation preparation) {
        return new EditorScene(name, editor -> {
            editor.escape();
            preparation.prepare(editor);
            return null;
        });
    }

    static List<EditorScene> all() {
        return Stream.of(windows(), dialogues(), fileDialogues())
                .flatMap(List::stream)
                .toList();
    }

    static List<EditorScene> dialogues() {
        List<EditorScene> scenes = new ArrayList<>();
        for (Menu menu : Menu.values()) {
            String name = "menu-" + menu.name().toLowerCase(java.util.Locale.ROOT);
            scenes.add(new EditorScene(name, editor -> menu(editor, menu)));
        }
        for (String part : PARTS) {
            scenes.add(new EditorScene("dialogue-" + part, editor -> {
                editor.run("select ids=solids/block");
                DialogFrame.Content content =
                        editor.dialogue(part).orElseThrow(() -> new IllegalStateException("no dialogue " + part));
                return fitting(editor, content.panel());
            }));
        }
        scenes.add(question(
                "close",
                WindowText.ASK_CLOSE.with("a room with a view.json"),
                WindowText.SAVE.words(),
                WindowText.DISCARD.words(),
                WindowText.CANCEL.words()));
        scenes.add(question("loses", FileText.LOSES.words(), WindowText.YES.words(), WindowText.NO.words()));
        scenes.add(question(
                "changed",
                FileText.CHANGED_QUESTION.words().with("room.json"),
                FileText.KEEP_MINE.words(),
                FileText.LOAD_THEIRS.words()));
        return scenes;
    }

    private static EditorScene question(String name, Words question, Words... answers) {
        return new EditorScene("question-" + name, editor -> {
            Language language = editor.look().language();
            Object[] buttons = java.util.Arrays.stream(answers)
                    .map(words -> words.in(language))
                    .toArray();
            return fitting(
                    editor,
                    new JOptionPane(
                            SwingQuestions.text(question.in(language)),
                            JOptionPane.WARNING_MESSAGE,
                            JOptionPane.DEFAULT_OPTION,
                            null,
                            buttons,
                            buttons[0]));
        });
    }

    private static JComponent menu(PicturedEditor editor, Menu menu) {
        JMenuBar bar = editor.the(JMenuBar.class);
        String title = menu.title().in(editor.look().language());
        for (int i = 0; i < bar.getMenuCount(); i++) {
            JMenu each = bar.getMenu(i);
            if (each.getText().equals(title)) {
                JPopupMenu popup = each.getPopupMenu();
                return fitting(editor, popup);
            }
        }
        throw new IllegalStateException("no menu " + title);
    }

    private static JComponent fitting(PicturedEditor editor, JComponent part) {
        Dimension size = part.getPreferredSize();
        Dimension screen = editor.look().screen();
        if (size.width > screen.width || size.height > screen.height) {
            throw new IllegalStateException(size + " does not fit on a screen of " + screen);
        }
        return part;
    }

    /** The whole window: with each tool in use, each tab, each kind of view, and each step of the guide. */
    private static List<EditorScene> windows() {
        List<EditorScene> scenes = new ArrayList<>();
        Tools.ALL.forEach(tool -> scenes.add(whole("tool-" + tool.id(), editor -> use(editor, tool))));
        scenes.add(whole("palette", editor -> {
            selectTool(editor);
            tab(editor, PalettePanel.class);
        }));
        scenes.add(whole("several-selected", editor -> {
            tab(editor, nephele.editor.panel.OutlinerPanel.class);
            editor.run("select ids=lights/lamp,lights/spot", "one-pane", "lit");
        }));
        scenes.add(whole("problems", EditorScene::problems));
        scenes.add(whole("history", editor -> {
            editor.run("select ids=cameras/flight", "collision");
            tab(editor, nephele.editor.panel.HistoryPanel.class);
        }));
        scenes.add(whole("wireframe", editor -> editor.run("select ids=models/teapot", "wireframe")));
        scenes.add(whole("portalable", editor -> {
            tab(editor, ProblemsPanel.class);
            editor.run("select ids=environment.clouds/cloud", "portalable");
        }));
        scenes.addAll(guide());
        return scenes;
    }

    private static void selectTool(PicturedEditor editor) throws Exception {
        editor.run("tool-select");
    }

    private static void tab(PicturedEditor editor, Class<? extends java.awt.Component> part) {
        java.awt.Component page = PaintedPanel.all(editor.panel(), part).get(0);
        ((JTabbedPane) page.getParent()).setSelectedComponent(page);
    }

    private static void use(PicturedEditor editor, ToolEntry tool) throws Exception {
        String selected = SELECTED.get(tool.id());
        editor.run(selected == null ? "select-none" : "select ids=" + selected);
        editor.session().options().entity("bodies", "box");
        editor.run("tool-" + tool.id());
        OffscreenHand hand = editor.hand();
        switch (tool.id()) {
            case "brush" -> hand.hold(OffscreenHand.TOP, new Vec3(2, 0, 0), new Vec3(4, 0, 3));
            case "clip" -> hand.hold(OffscreenHand.TOP, new Vec3(-1.5, 0, -3), new Vec3(1.5, 0, -1));
            case "measure" -> hand.hold(OffscreenHand.PERSPECTIVE, FLOOR, BLOCK_TOP);
            case "select" -> hand.hold(OffscreenHand.TOP, new Vec3(-3, 0, 1), new Vec3(-4.5, 0, 4));
            case "portal", "paint", "portalable" -> hand.hover(OffscreenHand.PERSPECTIVE, WALL);
            case "extrude", "vertex" -> hand.hover(OffscreenHand.PERSPECTIVE, BLOCK_TOP);
            default -> hand.hover(OffscreenHand.PERSPECTIVE, FLOOR);
        }
    }

    private static void problems(PicturedEditor editor) throws Exception {
        ProblemsPanel problems = editor.the(ProblemsPanel.class);
        EditorSession session = editor.session();
        problems.show(session.background()
                .get(() -> ProblemSearch.of(session.document().level(), session.assets())));
        editor.run("select ids=materials/" + editor.session().options().material(), "four-panes", "unlit");
    }

    private static List<EditorScene> guide() {
        List<EditorScene> scenes = new ArrayList<>();
        int last = GuideStep.values().length;
        scenes.add(whole("guide-" + last, editor -> {
            editor.run("select-none", "lit");
            editor.ui().show("guide");
        }));
        for (int step = last - 1; step > 0; step--) {
            scenes.add(whole("guide-" + step, editor -> editor.click("guide-back")));
        }
        scenes.add(whole("guide-end", editor -> {
            editor.click("guide-skip");
            editor.click("guide-skip");
        }));
        return scenes;
    }

    /** The dialogues about files and pixels, whose content is made for them. */
    private static List<EditorScene> fileDialogues() {
        return List.of(
                new EditorScene("recovery", EditorScene::recovery),
                new EditorScene("backups", EditorScene::backups),
                new EditorScene("explanation", EditorScene::explanation));
    }

    private static EditorSession sessionIn(Path folder, DocumentFile.Opened opened, PicturedEditor editor) {
        var session = new EditorSession(
                opened.file(), opened.level(), opened.assets(), editor.look().settings());
        session.fileServices(FileServices.of(EditorFiles.of(null, folder)));
        session.background().runOn(new WaitingLoop(() -> {}));
        return session;
    }

    private static JComponent recovery(PicturedEditor editor) throws Exception {
        Path folder = Files.createTempDirectory("nephele-editor-pictures");
        try {
            Level level = editor.session().document().level();
            EditorSession lost = sessionIn(folder, DocumentFile.untitled(), editor);
            var journals = new JournalFolder(folder.resolve("journal"), Clock.systemUTC());
            var journal = new SessionJournal(lost, journals, words -> {});
            lost.document().edit(Words.of("Draw room", "Desenhar sala", "Desenhar sala"), before -> level);
            journal.leave();
            EditorSession next = sessionIn(folder, DocumentFile.untitled(), editor);
            try (var finder = new SessionJournal(
                    next, new JournalFolder(folder.resolve("journal"), Clock.systemUTC()), words -> {})) {
                var works = new RecoveryList(finder, finder.lost(), Instant.now(), ZoneOffset.UTC);
                return new RecoveryPanel(works, editor.look().language(), question -> true, () -> true, () -> {});
            }
        } finally {
            TemporaryFolder.delete(folder);
        }
    }

    private static JComponent backups(PicturedEditor editor) throws Exception {
        Path folder = Files.createTempDirectory("nephele-editor-pictures");
        try {
            return backups(editor, folder);
        } finally {
            TemporaryFolder.delete(folder);
        }
    }

    private static JComponent backups(PicturedEditor editor, Path folder) throws IOException, EditorRefusal {
        Path file = folder.resolve("room.json");
        EditorSession session = sessionIn(folder, DocumentFile.untitled(), editor);
        session.fileServices().saver().saveAs(file, editor.session().document().level());
        EditorSession opened =
                sessionIn(folder, session.background().get(() -> DocumentFile.open(file.toString())), editor);
        opened.fileServices().saver().saveAs(file, DocumentFile.untitled().level());
        return new BackupsPanel(
                new BackupList(opened, Instant.now(), ZoneOffset.UTC),
                editor.look().language(),
                () -> true,
                words -> {},
                () -> {});
    }

    private static JComponent explanation(PicturedEditor editor) {
        var explained = new PixelExplanation(List.of("solids/room-floor  +y", "lights/lamp: 0.42 W/m²"));
        return new ExplanationPanel(explained, editor.look().language(), text -> {}, () -> {});
    }
}
