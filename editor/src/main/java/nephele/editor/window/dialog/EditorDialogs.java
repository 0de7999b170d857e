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
import nephele.editor.action.ActionFailure;
import nephele.editor.action.Actions;
import nephele.editor.action.Desk;
import nephele.editor.action.EditorCommand;
import nephele.editor.panel.model.PaletteModel;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.text.Words;
import nephele.editor.window.EditorPanel;

/** The dialogues of one window, opened by the names of its parts. */
public final class EditorDialogs {
    private final EditorSession session;
    private final Desk desk;
    private final EditorPanel panel;
    private final DialogOpener frame;

    /** @param frame shows the dialogues */
    public EditorDialogs(EditorSession session, Desk desk, EditorPanel panel, DialogOpener frame) {
        this.session = session;
        this.desk = desk;
        this.panel = panel;
        this.frame = frame;
    }

    /** Registers all dialogues, each with what opens it. */
    public void register(BiConsumer<String, Runnable> parts) {
        parts.accept("palette", this::showPalette);
        parts.accept("add", this::showKinds);
        parts.accept("open-recent", this::showRecent);
        parts.accept("screenshot", this::savePicture);
        ActionForms.ALL.forEach(form -> parts.accept(form.part(), () -> show(form)));
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
            SearchList<PaletteModel.Entry> list = Searches.kinds(session.language(), chosen -> {
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

    private void add(PaletteModel.Entry entry) {
        Map<String, String> values = new LinkedHashMap<>();
        values.put("kind", entry.section() + "." + entry.kind());
        values.put("at", ViewedPlace.text(session));
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
            Actions.named(action).orElseThrow().run(new ActionCall(session, desk, values));
            return Words.NONE;
        } catch (ActionFailure failure) {
            return failure.told();
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
}
