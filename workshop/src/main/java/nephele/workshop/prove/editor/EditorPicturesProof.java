package nephele.workshop.prove.editor;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.swing.JComponent;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Draws the editor in each look with each tool, panel, menu and dialogue, and searches for texts that are cut off. */
public final class EditorPicturesProof implements Proof {
    private static final Path FOLDER = Path.of("build", "editor-pictures");

    private final int every;

    /** @param every of how many pictures one is painted; all are laid out and searched */
    public EditorPicturesProof(int every) {
        this.every = every;
    }

    @Override
    public Claim claim() {
        return new Claim(
                "editor-pictures",
                "In the pictures of each tool, panel, menu, dialogue and step of the guide, light and dark, at 100 %"
                        + " (1280 × 800) and 200 % (1920 × 1200), in three languages, no text is cut off but names of"
                        + " the user's.",
                "looks",
                EditorLook.ALL.size(),
                1);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) throws Exception {
        List<String> failures = new ArrayList<>();
        long searched = 0;
        long painted = 0;
        try (WatchedEvents events = new WatchedEvents()) {
            for (long unit = from; unit < from + count; unit++) {
                Look look = new Look(EditorLook.ALL.get((int) unit), events, every, (int) unit);
                look.run().forEach(failure -> {
                    failures.add(failure);
                    progress.failed(failure);
                });
                searched += look.searched;
                painted += look.painted;
                progress.unitsDone(unit - from + 1);
            }
        }
        return ProofResult.of(
                count, failures, Figure.sum("pictures searched", searched, ""), Figure.sum("painted", painted, ""));
    }

    /** One look and its pictures. */
    private static final class Look {
        private final EditorLook look;
        private final WatchedEvents events;
        private final int every;
        private final int first;
        private PicturedEditor editor;
        private int searched;
        private int painted;

        Look(EditorLook look, WatchedEvents events, int every, int first) {
            this.look = look;
            this.events = events;
            this.every = every;
            this.first = first;
        }

        /** Returns a failure for each picture with a text that is cut off, or that cannot be made. */
        List<String> run() throws InterruptedException {
            List<String> failures = new ArrayList<>();
            events.run(() -> editor = new PicturedEditor(look)).ifPresent(failures::add);
            if (failures.isEmpty()) {
                List<EditorScene> scenes = EditorScene.all();
                for (EditorScene scene : scenes) {
                    List<String> cut = new ArrayList<>();
                    Optional<String> thrown = events.run(() -> cut.addAll(cutTexts(scene)));
                    thrown.ifPresent(cut::add);
                    if (!cut.isEmpty()) {
                        failures.add(look.title() + ", " + scene.name() + ": " + String.join("; ", cut));
                    }
                }
                events.run(editor::close).ifPresent(failures::add);
            }
            return failures;
        }

        private List<String> cutTexts(EditorScene scene) throws Exception {
            boolean isPainted = (searched++ + first) % every == 0;
            JComponent part = scene.making().show(editor);
            if (part == null) {
                List<String> cut = editor.cut();
                if (isPainted) {
                    write(scene, editor.picture());
                }
                return cut;
            }
            PaintedPanel panel = new PaintedPanel(part);
            if (isPainted) {
                write(scene, panel.picture());
            }
            return editor.cut(part);
        }

        private void write(EditorScene scene, BufferedImage picture) throws IOException {
            painted++;
            Files.createDirectories(FOLDER);
            ImageIO.write(
                    picture,
                    "png",
                    FOLDER.resolve(scene.name() + "-" + look.title() + ".png").toFile());
        }
    }
}
