package nephele.editor.window.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Instant;
import java.time.InstantSource;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import javax.imageio.ImageIO;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.KeyStroke;
import nephele.editor.file.BackupList;
import nephele.editor.file.FiledSession;
import nephele.editor.file.OutsideChanges;
import nephele.editor.file.RecoveryList;
import nephele.editor.file.SessionJournal;
import nephele.editor.pane.PaneLayout;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.pane.ViewMode;
import nephele.editor.save.DraftLevel;
import nephele.editor.save.journal.JournalFolder;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.EditorSetting.Theme;
import nephele.editor.session.EditorSettings;
import nephele.editor.text.Words;
import nephele.editor.window.WindowLook;
import nephele.editor.window.viewport.ViewportPanel;
import nephele.engine.level.Language;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.level.json.LevelFile;
import nephele.engine.math.Vec3;
import nephele.workshop.prove.editor.CutTexts;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The dialogues about files, painted and used without a display. */
@Execution(ExecutionMode.SAME_THREAD)
class FilePanelsSwingTest {
    private static final Instant NOW = Instant.parse("2026-01-02T14:02:05Z");

    @TempDir
    Path folder;

    private final List<String> asked = new ArrayList<>();
    private boolean isAgreed = true;
    private boolean isDone;

    private static Level level() {
        return LevelFile.read(Path.of("levels/02-first-shot.json"));
    }

    /** Leaves the work of two sessions, the newer one with a picture. */
    private JournalFolder lost() throws IOException {
        JournalFolder early =
                new JournalFolder(folder.resolve("journal"), InstantSource.fixed(NOW.minusSeconds(90000)));
        EditorSession untitled = FiledSession.untitled(folder);
        SessionJournal first = new SessionJournal(untitled, early, words -> {});
        FiledSession.edit(untitled, level());
        first.leave();
        JournalFolder journals = new JournalFolder(folder.resolve("journal"), InstantSource.fixed(NOW));
        EditorSession named = FiledSession.of(folder, folder.resolve("a room.json"), DraftLevel.after(0));
        SessionJournal second = new SessionJournal(named, journals, words -> {});
        FiledSession.edit(named, DraftLevel.after(1));
        FiledSession.edit(named, DraftLevel.after(2));
        second.picture(Files.readAllBytes(picture(0xc04020)));
        second.leave();
        return journals;
    }

    private Path picture(int rgb) throws IOException {
        BufferedImage picture = new BufferedImage(320, 180, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < 180; y++) {
            for (int x = 0; x < 320; x++) {
                picture.setRGB(x, y, rgb);
            }
        }
        Path file = folder.resolve("seen.png");
        ImageIO.write(picture, "png", file.toFile());
        return file;
    }

    private RecoveryPanel recovery(RecoveryList lost, Language language) {
        return new RecoveryPanel(
                lost, language, question -> asked.add(question.english()) && isAgreed, () -> true, () -> isDone = true);
    }

    private static void look(Theme theme, int percent) {
        WindowLook.apply(
                EditorSettings.DEFAULT.with(EditorSetting.THEME, theme).with(EditorSetting.SCALE_PERCENT, percent));
    }

    private static BufferedImage painted(JComponent panel, String name) throws IOException {
        panel.setSize(panel.getPreferredSize());
        layOut(panel);
        layOut(panel);
        Dimension size = panel.getSize();
        BufferedImage picture = new BufferedImage(size.width, size.height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = picture.createGraphics();
        panel.paint(graphics);
        graphics.dispose();
        new File("build/pictures").mkdirs();
        ImageIO.write(picture, "png", new File("build/pictures/" + name + ".png"));
        return picture;
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"DARK, 100, EN", "LIGHT, 100, PT_BR", "DARK, 200, PT_PT"})
    void theOfferShowsAllOfALostSession(Theme theme, int percent, Language language) throws IOException {
        look(theme, percent);
        SessionJournal journal = new SessionJournal(FiledSession.untitled(folder), lost(), words -> {});
        RecoveryList lost = new RecoveryList(journal, journal.lost(), NOW, ZoneOffset.UTC);
        RecoveryPanel panel = recovery(lost, language);
        BufferedImage picture = painted(panel, "recovery-" + theme + "-" + percent + "-" + language);
        JLabel label = named(panel, "picture", JLabel.class);
        Point middle = new Point(label.getWidth() / 2, label.getHeight() / 2);
        Point at = javax.swing.SwingUtilities.convertPoint(label, middle, panel);
        assertEquals(0xc04020, picture.getRGB(at.x, at.y) & 0xffffff, "the picture of the newest is shown");
        assertEquals(List.of(), CutTexts.in(panel));
        assertTrue(label.getAccessibleContext().getAccessibleName().contains("a room.json"));
        ((JList<?>) panel.rows()).setSelectedIndex(1);
        painted(panel, "recovery-plan-" + theme + "-" + percent + "-" + language);
        assertTrue(label.getIcon() != null, "a plan where there is no picture");
        journal.close();
    }

    private static <T extends Component> T named(Container container, String name, Class<T> type) {
        for (Component child : container.getComponents()) {
            if (type.isInstance(child) && name.equals(child.getName())) {
                return type.cast(child);
            }
            T inner = child instanceof Container deeper ? named(deeper, name, type) : null;
            if (inner != null) {
                return inner;
            }
        }
        return null;
    }

    private static void press(JComponent part, String key) {
        Object action =
                part.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).get(KeyStroke.getKeyStroke(key));
        part.getActionMap().get(action).actionPerformed(null);
    }

    @Test
    void keysRecoverDiscardAndLeave() throws IOException {
        look(Theme.DARK, 100);
        EditorSession session = FiledSession.untitled(folder);
        SessionJournal journal = new SessionJournal(session, lost(), words -> {});
        RecoveryList lost = new RecoveryList(journal, journal.lost(), NOW, ZoneOffset.UTC);
        RecoveryPanel panel = recovery(lost, Language.EN);
        isAgreed = false;
        press(panel.rows(), "DELETE");
        assertEquals(List.of("Delete the lost work on a room.json for good?"), asked);
        assertEquals(2, lost.works().size());
        press(panel, "ESCAPE");
        assertTrue(isDone);
        assertEquals(2, journal.lost().size(), "later");
        isAgreed = true;
        ((JList<?>) panel.rows()).setSelectedIndex(1);
        named(panel, "DISCARD", AbstractButton.class).doClick();
        assertEquals(1, journal.lost().size());
        press(panel.rows(), "ENTER");
        assertEquals(DraftLevel.after(2), session.document().level());
        assertTrue(session.document().isModified());
        journal.close();
    }

    @ParameterizedTest
    @CsvSource({"LIGHT, 100, EN", "DARK, 200, PT_BR"})
    void backupsAreListedWithPicturesAndRestored(Theme theme, int percent, Language language) throws IOException {
        look(theme, percent);
        Path file = folder.resolve("room.json");
        EditorSession session = FiledSession.of(folder, file, level());
        session.fileServices().saver().saveAs(file, DraftLevel.after(1));
        BackupList backups = new BackupList(session, Instant.now(), ZoneOffset.UTC);
        BackupsPanel panel = new BackupsPanel(
                backups, language, () -> true, words -> asked.add(words.english()), () -> isDone = true);
        painted(panel, "backups-" + theme + "-" + percent + "-" + language);
        assertEquals(List.of(), CutTexts.in(panel));
        session.document().edit(Words.same("x"), before -> DraftLevel.after(3));
        press(panel.rows(), "ENTER");
        assertTrue(isDone);
        assertEquals(level(), session.document().level());
        session.document().undo();
        named(panel, "OPEN_COPY", AbstractButton.class).doClick();
        assertTrue(session.file().path().isEmpty());
        assertEquals(level(), session.document().level());
        assertFalse(session.document().isModified());
    }

    /** Looks down on the floor of the level from 5 m above it. */
    private static ViewportPanel viewport(EditorSession session) {
        ViewportPanel viewport = new ViewportPanel(session, at -> {}, line -> {});
        viewport.setSize(400, 300);
        layOut(viewport);
        viewport.picture();
        session.panes(panes -> panes.with(PaneLayout.Arrangement.ONE));
        session.panes(panes -> panes.with(
                panes.active(),
                panes.activeView()
                        .with(new PerspectiveCamera(new Vec3(0.1, 5, 0.1), 0, -89, 60))
                        .with(ViewMode.UNLIT)));
        return viewport;
    }

    private EditorSession roomWithFolder() throws IOException {
        Path levels = Files.createDirectory(folder.resolve("levels"));
        return FiledSession.of(folder, levels.resolve("room.json"), DraftLevel.after(0));
    }

    @Test
    void filesDroppedOnAFaceAreUsedAndTheOthersToldTogether() throws IOException {
        look(Theme.DARK, 100);
        EditorSession session = roomWithFolder();
        List<Words> refused = new ArrayList<>();
        try (ViewportPanel viewport = viewport(session)) {
            Path text = Files.writeString(folder.resolve("a.txt"), "x");
            new FileDrops(session, viewport, () -> true, refused::add)
                    .drop(List.of(text, picture(0x808080), folder), new Point(200, 150));
        }
        assertEquals(
                "seen",
                SolidFaces.authored(session.document().level().solids().get(0), "+y")
                        .material());
        assertEquals(1, refused.size());
        assertEquals(2, refused.get(0).english().lines().count());
    }

    @Test
    void aPictureThatChangesOnDiskChangesInTheViewport() throws IOException {
        look(Theme.DARK, 100);
        EditorSession session = roomWithFolder();
        try (ViewportPanel viewport = viewport(session)) {
            new FileDrops(session, viewport, () -> true, refused -> {})
                    .drop(List.of(picture(0xd02020)), new Point(200, 150));
            int before = viewport.picture().getRGB(210, 160);
            assertTrue((before >> 16 & 255) > (before & 255) + 50, Integer.toHexString(before));
            Path asset = folder.resolve("levels").resolve("textures").resolve("seen.png");
            Files.copy(picture(0x2020d0), asset, StandardCopyOption.REPLACE_EXISTING);
            new OutsideChanges(session, question -> true, message -> {}).changed(Set.of(asset));
            int after = viewport.picture().getRGB(210, 160);
            assertTrue((after & 255) > (after >> 16 & 255) + 50, Integer.toHexString(after));
        }
    }

    @Test
    void thePictureOfLostWorkIsWhatTheUserSaw() throws IOException {
        look(Theme.DARK, 100);
        EditorSession session = roomWithFolder();
        List<byte[]> kept = new ArrayList<>();
        try (ViewportPanel viewport = viewport(session);
                JournalPictures pictures = new JournalPictures(session, viewport, Runnable::run, kept::add)) {
            new FileDrops(session, viewport, () -> true, refused -> {})
                    .drop(List.of(picture(0xd02020)), new Point(200, 150));
            viewport.picture();
            session.document().drag(start -> start);
            pictures.take();
            assertEquals(0, kept.size(), "not in the middle of a drag");
            session.document().cancelDrag();
            pictures.take();
        }
        BufferedImage picture = ImageIO.read(new java.io.ByteArrayInputStream(kept.get(0)));
        assertTrue(picture.getWidth() <= 320 && picture.getHeight() == 200, picture.toString());
        int middle = picture.getRGB(picture.getWidth() / 2 + 5, 105);
        assertTrue((middle >> 16 & 255) > (middle & 255) + 50, Integer.toHexString(middle));
    }
}
