package nephele.editor.window;

import java.awt.GraphicsEnvironment;
import java.awt.Toolkit;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import javax.swing.JFileChooser;
import javax.swing.filechooser.FileNameExtensionFilter;
import nephele.editor.action.UserInterface;
import nephele.editor.file.DroppedFile;
import nephele.editor.file.DroppedFile.SceneUse;
import nephele.editor.file.FileText;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.level.Language;
import nephele.host.userfile.UserFolders;

/** The user interface of a window: file choosers, questions, the system's clipboard and the parts that can be shown. */
public final class WindowInterface implements UserInterface {
    private static final Words NO_PICTURE = Words.of(
            "There is no window to take a picture of",
            "Não há janela para capturar a imagem",
            "Não há janela de que tirar uma imagem");

    private final EditorSession session;
    private final Map<String, Runnable> parts = new LinkedHashMap<>();
    private EditorWindow window;

    public WindowInterface(EditorSession session) {
        this.session = session;
    }

    /** Names the window that this belongs to; called once, when it exists. */
    void attach(EditorWindow owner) {
        window = owner;
    }

    /** Registers a part that {@link #show} opens; one with the id of an action asks for its values. */
    public void part(String name, Runnable opener) {
        parts.put(name, opener);
    }

    @Override
    public Optional<Path> fileToOpen() {
        JFileChooser chooser = chooser();
        return chooser.showOpenDialog(window) == JFileChooser.APPROVE_OPTION
                ? Optional.of(chooser.getSelectedFile().toPath())
                : Optional.empty();
    }

    @Override
    public Optional<Path> fileToSave() {
        JFileChooser chooser = chooser();
        session.file().path().map(Path::toFile).ifPresentOrElse(chooser::setSelectedFile, () -> inOwnLevels(chooser));
        return chooser.showSaveDialog(window) == JFileChooser.APPROVE_OPTION
                ? Optional.of(withEnding(chooser.getSelectedFile()))
                : Optional.empty();
    }

    @Override
    public Optional<Path> fileToExport() {
        JFileChooser chooser = chooser();
        chooser.setFileFilter(new FileNameExtensionFilter(WindowText.PACKAGES.in(session.language()), "zip"));
        if (session.file().path().isEmpty()) {
            inOwnLevels(chooser);
        }
        String name = EditorWindow.name(session).replaceFirst("\\.json$", "") + ".zip";
        chooser.setSelectedFile(new File(chooser.getCurrentDirectory(), name));
        return chooser.showSaveDialog(window) == JFileChooser.APPROVE_OPTION
                ? Optional.of(chooser.getSelectedFile().toPath())
                : Optional.empty();
    }

    @Override
    public Optional<Path> fileToAdd() {
        JFileChooser chooser = chooser();
        String[] endings = Arrays.stream(DroppedFile.Kind.values())
                .flatMap(kind -> kind.endings().stream())
                .toArray(String[]::new);
        chooser.setFileFilter(new FileNameExtensionFilter(WindowText.ADDABLE_FILES.in(session.language()), endings));
        return chooser.showOpenDialog(window) == JFileChooser.APPROVE_OPTION
                ? Optional.of(chooser.getSelectedFile().toPath())
                : Optional.empty();
    }

    @Override
    public boolean isRemedied(Words problem, Words remedy) {
        Language language = session.language();
        return new SwingQuestions(window)
                        .choice(problem.in(language), language, remedy.in(language), WindowText.CANCEL.in(language))
                == 0;
    }

    @Override
    public Optional<SceneUse> sceneUse(Path scene) {
        Language language = session.language();
        int chosen = new SwingQuestions(window)
                .choice(
                        FileText.INSERT_OR_OPEN.with(scene.getFileName()).in(language),
                        language,
                        FileText.INSERT.in(language),
                        FileText.OPEN_INSTEAD.in(language),
                        WindowText.CANCEL.in(language));
        return chosen == 0
                ? Optional.of(SceneUse.INSERT)
                : chosen == 1 ? Optional.of(SceneUse.REPLACE) : Optional.empty();
    }

    private static Path withEnding(File chosen) {
        return chosen.getName().contains(".") ? chosen.toPath() : Path.of(chosen.getPath() + ".json");
    }

    /** Proposes the folder that the game lists for a level that has no place yet. */
    private static void inOwnLevels(JFileChooser chooser) {
        Path folder = UserFolders.ofThisUser().levels();
        if (folder != null && (Files.isDirectory(folder) || folder.toFile().mkdirs())) {
            chooser.setCurrentDirectory(folder.toFile());
        }
    }

    private JFileChooser chooser() {
        File folder =
                session.file().path().map(Path::getParent).map(Path::toFile).orElse(new File("."));
        JFileChooser chooser = new JFileChooser(folder);
        chooser.setFileFilter(
                new FileNameExtensionFilter(WindowText.LEVEL_FILES.in(session.language()), "json", "zip"));
        return chooser;
    }

    @Override
    public boolean isAgreed(Words question) {
        return new SwingQuestions(window).isAgreed(question.in(session.language()), session.language());
    }

    @Override
    public BufferedImage picture() throws EditorRefusal {
        if (window == null) {
            throw new EditorRefusal(NO_PICTURE);
        }
        return window.panel().pictureAsShown();
    }

    private static Optional<Clipboard> clipboard() {
        return GraphicsEnvironment.isHeadless()
                ? Optional.empty()
                : Optional.of(Toolkit.getDefaultToolkit().getSystemClipboard());
    }

    @Override
    public void copy(String text) {
        session.clipboard(text);
        clipboard().ifPresent(system -> {
            try {
                system.setContents(new StringSelection(text), null);
            } catch (IllegalStateException busy) {
                // Another program holds it; the session's own clipboard has the text.
            }
        });
    }

    @Override
    public String pasted() {
        return clipboard().flatMap(WindowInterface::text).orElseGet(session::clipboard);
    }

    private static Optional<String> text(Clipboard system) {
        try {
            return Optional.of((String) system.getData(DataFlavor.stringFlavor));
        } catch (UnsupportedFlavorException | IOException | IllegalStateException noText) {
            return Optional.empty();
        }
    }

    @Override
    public void show(String part) {
        Optional.ofNullable(parts.get(part)).ifPresent(Runnable::run);
    }

    @Override
    public boolean asks(String action) {
        Optional<Runnable> opener = Optional.ofNullable(parts.get(action));
        opener.ifPresent(Runnable::run);
        return opener.isPresent();
    }

    @Override
    public void quit() {
        if (window != null) {
            window.closeIfAllowed();
        }
    }
}
