package nephele.editor.window.dialog;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.function.Function;
import javax.swing.JFileChooser;
import javax.swing.filechooser.FileNameExtensionFilter;
import nephele.editor.action.ActionCall;
import nephele.editor.action.Actions;
import nephele.editor.action.EditorCommand;
import nephele.editor.action.UserInterface;
import nephele.editor.document.Picker;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.panel.model.PaletteEntry;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.editor.window.EditorPanel;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** The dialogues of one window, opened by the names of its parts. */
public final class EditorDialogs {
    private static final double MOST_METRES = 20;
    private static final double FREE_METRES = 4;
    private static final double STANDOFF_METRES = 0.5;

    private final EditorSession session;
    private final UserInterface ui;
    private final EditorPanel panel;
    private final DialogOpener frame;

    /** @param frame shows the dialogues */
    public EditorDialogs(EditorSession session, UserInterface ui, EditorPanel panel, DialogOpener frame) {
        this.session = session;
        this.ui = ui;
        this.panel = panel;
        this.frame = frame;
    }

    /** Registers all dialogues, each with what opens it. */
    public void register(BiConsumer<String, Runnable> parts) {
        parts.accept("palette", this::showPalette);
        parts.accept("add", this::showKinds);
        parts.accept("open-recent", this::showRecent);
        parts.accept("screenshot", this::savePicture);
        ActionForm.ALL.forEach(form -> parts.accept(form.part(), () -> show(form)));
    }

    private void showPalette() {
        frame.open(DialogText.SEARCH_COMMANDS.in(session.language()), close -> {
            SearchList<EditorCommand> list =
                    Searches.commands(panel.commands().all(), panel.keys(), session.language(), chosen -> {
                        close.run();
                        chosen.ifPresent(EditorCommand::run);
                    });
            return new DialogFrame.Content(list, list.query(), null);
        });
    }

    private void showKinds() {
        frame.open(DialogText.ADD.in(session.language()), close -> {
            SearchList<PaletteEntry> list = Searches.kinds(session.language(), chosen -> {
                close.run();
                chosen.ifPresent(this::add);
            });
            return new DialogFrame.Content(list, list.query(), null);
        });
    }

    private void showRecent() {
        List<Path> files = session.settings().get(EditorSetting.RECENT_FILES).stream()
                .map(Path::of)
                .filter(Files::isRegularFile)
                .toList();
        frame.open(DialogText.OPEN_RECENT.in(session.language()), close -> {
            SearchList<Path> list = Searches.files(files, session.language(), chosen -> {
                close.run();
                chosen.ifPresent(file -> session.status(run("open", Map.of("file", file.toString()))));
            });
            return new DialogFrame.Content(list, list.query(), null);
        });
    }

    private void add(PaletteEntry entry) {
        Map<String, String> values = new LinkedHashMap<>();
        values.put("kind", entry.section() + "." + entry.kind());
        values.put("at", text(session));
        session.status(run("add", values));
    }

    private void show(ActionForm form) {
        boolean isEnabled =
                Actions.named(form.action()).orElseThrow().isEnabled().test(session);
        if (!isEnabled) {
            return;
        }
        frame.open(form.title().in(session.language()), close -> {
            Function<Map<String, String>, Words> run = values -> run(form.action(), values);
            FormPanel made = new FormPanel(form, session, run, close);
            return new DialogFrame.Content(made, made.first(), made.acceptButton());
        });
    }

    /** Runs an action with values; returns what went wrong, or {@link Words#NONE}. */
    private Words run(String action, Map<String, String> values) {
        try {
            Actions.named(action).orElseThrow().run(new ActionCall(session, ui, values));
            return Words.NONE;
        } catch (EditorRefusal failure) {
            return failure.words();
        }
    }

    /** Asks for a file of its own: the one of the level would be lost. */
    private void savePicture() {
        JFileChooser chooser = new JFileChooser();
        chooser.setFileFilter(new FileNameExtensionFilter(DialogText.PICTURES.in(session.language()), "png"));
        if (chooser.showSaveDialog(panel) == JFileChooser.APPROVE_OPTION) {
            String path = chooser.getSelectedFile().getPath();
            session.status(run("screenshot", Map.of("file", path.endsWith(".png") ? path : path + ".png")));
        }
    }

    private static Ray ahead(PerspectiveCamera camera, PaneSize size) {
        return camera.ray(size.width() / 2.0, size.height() / 2.0, size);
    }

    /** Returns the place on the grid as {@code x,y,z}. */
    static String text(EditorSession session) {
        Vec3 at = session.grid().snapped(of(session));
        return at.x() + "," + at.y() + "," + at.z();
    }

    /** Returns a place in front of the nearest surface ahead, or ahead in the air; in a plan, its middle. */
    static Vec3 of(EditorSession session) {
        PaneView view = session.panes().activeView();
        if (view.kind() != PaneKind.PERSPECTIVE) {
            return view.plan().centre();
        }
        PerspectiveCamera camera = view.perspective();
        List<Picker.Pick> ahead = session.context().picker().surfaces(ahead(camera, session.viewport()));
        if (ahead.isEmpty() || ahead.get(0).point().minus(camera.eye()).length() > MOST_METRES) {
            return camera.eye().addScaled(FREE_METRES, camera.forward());
        }
        return ahead.get(0).point().addScaled(STANDOFF_METRES, ahead.get(0).normal());
    }
}
