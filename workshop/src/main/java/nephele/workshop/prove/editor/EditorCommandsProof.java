package nephele.workshop.prove.editor;

import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import nephele.editor.action.ScriptInterface;
import nephele.editor.action.ScriptRunner;
import nephele.editor.document.Document;
import nephele.editor.document.Selection;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.save.ContentHash;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSettings;
import nephele.editor.text.EditorRefusal;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Runs seeded random commands on an empty level, undoes all of them, and makes all of them again. */
public final class EditorCommandsProof implements Proof {
    /** Above so many entities, half of the level is deleted more often than anything is added. */
    private static final int MANY_ENTITIES = 150;

    private static final List<String> LINES = List.of(
            "brush box min=%d,0,%d max=%d,3,%d",
            "brush wedge min=%d,0,%d max=%d,3,%d",
            "brush cylinder min=%d,0,%d max=%d,2,%d",
            "add lights.point at=%d,3,%d",
            "add bodies.sphere at=%d,1,%d",
            "add portals at=%d,1,%d",
            "add environment.clouds at=%d,50,%d",
            "add player at=%d,0,%d",
            "add environment.sun",
            "move by=%d,0.5,%d",
            "turn degrees=90 pivot=%d,0,%d",
            "turn degrees=37 pivot=%d,0,%d",
            "scale by=0.5,2,1 pivot=%d,0,%d",
            "duplicate by=%d,0,%d",
            "delete",
            "hide",
            "lock",
            "group",
            "ungroup",
            "show-all",
            "unlock-all",
            "hollow wall=0.25",
            "subtract",
            "merge",
            "copy",
            "paste by=%d,1,%d",
            "isolate",
            "set portalable to=true",
            "undo",
            "redo");

    @Override
    public Claim claim() {
        return new Claim(
                "editor-commands",
                "After random commands, all undone and then redone, the text of the level after each step is byte for"
                        + " byte the same both ways; a command that is refused changes nothing.",
                "commands",
                10_000,
                10_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) throws Exception {
        Run run = new Run(new SplittableRandom(15 + from));
        for (long command = 1; command <= count; command++) {
            run.chooseSelection();
            run.command();
            progress.unitsDone(command);
        }
        run.compareBothWays();
        return ProofResult.of(
                count,
                run.failures,
                Figure.sum("steps undone and redone", run.steps, ""),
                Figure.sum("commands refused", run.refused, ""),
                Figure.greatest("longest text", run.longest, "bytes"));
    }

    /** The commands of one level. */
    private static final class Run {
        private final SplittableRandom random;
        private final EditorSession session;
        private final ScriptRunner script;
        private final List<String> failures = new ArrayList<>();
        private long refused;
        private long steps;
        private long longest;

        Run(SplittableRandom random) {
            this.random = random;
            DocumentFile.Opened fresh = DocumentFile.untitled();
            session = new EditorSession(fresh.file(), fresh.level(), fresh.assets(), EditorSettings.DEFAULT);
            script = new ScriptRunner(
                    session, new ScriptInterface(() -> new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB)));
        }

        void chooseSelection() {
            Document document = session.document();
            List<EntityRef> all = Entities.LEVEL.all(document.level());
            if (all.size() > MANY_ENTITIES) {
                document.select(Selection.of(all.subList(0, all.size() / 2)));
                run("delete");
            } else if (!all.isEmpty() && random.nextInt(3) > 0) {
                document.select(Selection.of(
                        List.of(all.get(random.nextInt(all.size())), all.get(random.nextInt(all.size())))));
            }
        }

        void command() {
            Object[] numbers = {
                random.nextInt(9) - 4, random.nextInt(9) - 4, random.nextInt(4) + 5, random.nextInt(4) + 5
            };
            run(String.format(LINES.get(random.nextInt(LINES.size())), numbers));
        }

        /** A command that is not possible now, or that a brush refuses, changes nothing. */
        private void run(String line) {
            Level before = session.document().level();
            try {
                script.run(line);
            } catch (EditorRefusal failure) {
                refused++;
                if (session.document().level() != before) {
                    failures.add("refused, but changed the level: " + line);
                }
            }
        }

        void compareBothWays() {
            Document document = session.document();
            while (document.history().canRedo()) {
                document.redo();
            }
            List<String> backwards = new ArrayList<>(List.of(hash()));
            while (document.history().canUndo()) {
                document.undo();
                backwards.add(hash());
            }
            steps = backwards.size() - 1;
            String empty = LevelJson.write(DocumentFile.untitled().level());
            if (!LevelJson.write(document.level()).equals(empty)) {
                failures.add("all undone, the level is not the one of the beginning");
            }
            for (int step = backwards.size() - 1; step >= 0; step--) {
                difference(backwards.get(step)).ifPresent(failures::add);
                document.redo();
            }
        }

        private Optional<String> difference(String expected) {
            int position = session.document().history().position();
            return hash().equals(expected)
                    ? Optional.empty()
                    : Optional.of("the text after step " + position + " differs when it is made again");
        }

        private String hash() {
            byte[] text = LevelJson.write(session.document().level()).getBytes(StandardCharsets.UTF_8);
            longest = Math.max(longest, text.length);
            return ContentHash.of(text);
        }
    }
}
