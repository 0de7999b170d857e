package nephele.workshop.prove;

import java.io.IOException;
import java.io.PrintStream;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.TextFile;
import nephele.engine.reference.tile.Shard;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Runs one proof batch by batch from its last state, saves the state after each batch, and shows the progress. */
public final class ProofRun {
    private static final long PRINT_EVERY_NANOS = 2_000_000_000L;

    private final Proof proof;
    private final Path stateFolder;
    private final Shard shard;
    private final Path stateFile;
    private final PrintStream progressTo;
    private long lastPrintedNanos = System.nanoTime();

    public ProofRun(Proof proof, Path stateFolder, PrintStream progressTo) {
        this(proof, stateFolder, Shard.WHOLE, progressTo);
    }

    /** @param shard the part of the units that is run; several processes can run one each */
    public ProofRun(Proof proof, Path stateFolder, Shard shard, PrintStream progressTo) {
        this.proof = proof;
        this.stateFolder = stateFolder;
        this.shard = shard;
        this.stateFile = stateFile(shard);
        this.progressTo = progressTo;
    }

    private Path stateFile(Shard of) {
        String part = of.equals(Shard.WHOLE) ? "" : "-" + of.number() + "-of-" + of.of();
        return stateFolder.resolve(proof.claim().name() + part + ".properties");
    }

    /** Returns the first unit of the shard, after the last one of the shard before. */
    private long first() {
        return before(shard.number() - 1);
    }

    private long before(int shards) {
        return shards == 0 ? 0 : proof.claim().fullCount() * shards / shard.of();
    }

    /** Returns the result of this shard and of all others that were run at the same commit. */
    public ProofResult joined(String commit) throws IOException {
        ProofResult all = ProofResult.NOTHING;
        for (int number = 1; number <= shard.of(); number++) {
            Path part = stateFile(new Shard(number, shard.of()));
            all = all.and(load(part, commit));
        }
        return proof.judged(all);
    }

    /** Returns how many units the shard has. */
    public long size() {
        return before(shard.number()) - first();
    }

    /** Discards the results of earlier runs. */
    public void startOver(String commit) throws IOException {
        save(stateFile, commit, ProofResult.NOTHING);
    }

    /** Runs the missing units until {@code count} of the shard are done, and returns the result of all of them. */
    public ProofResult upTo(long count, String commit) throws Exception {
        ProofResult soFar = load(stateFile, commit);
        long first = first();
        while (soFar.units() < count) {
            long done = soFar.units();
            long batch = Math.min(proof.claim().batch(), count - done);
            var found = proof.run(first + done, batch, printed(done, count));
            if (found.units() != batch) {
                throw new IllegalStateException(proof.claim().name() + " ran " + found.units() + " of " + batch + " "
                        + proof.claim().unit());
            }
            soFar = soFar.and(found);
            save(stateFile, commit, soFar);
        }
        return proof.judged(soFar);
    }

    private Proof.Progress printed(long from, long count) {
        return new Proof.Progress() {
            @Override
            public void unitsDone(long done) {
                print(from + done, count);
            }

            @Override
            public void failed(String example) {
                progressTo.println(proof.claim().name() + ": failed: " + example);
            }
        };
    }

    /** Runs some units alone without saving the result. */
    public ProofResult alone(long from, long count) throws Exception {
        return proof.judged(proof.run(from, count, printed(0, count)));
    }

    private void print(long done, long count) {
        long now = System.nanoTime();
        if (now - lastPrintedNanos > PRINT_EVERY_NANOS) {
            lastPrintedNanos = now;
            progressTo.printf(
                    "%s: %,d of %,d %s%n",
                    proof.claim().name(), done, count, proof.claim().unit());
        }
    }

    /** Returns the saved result if it belongs to this commit, else none: changed code has to be proved again. */
    private static ProofResult load(Path file, String commit) throws IOException {
        if (!Files.exists(file)) {
            return ProofResult.NOTHING;
        }
        var saved = new Properties();
        saved.load(new StringReader(TextFile.text(Files.readAllBytes(file))));
        if (!commit.equals(saved.getProperty("commit"))) {
            return ProofResult.NOTHING;
        }
        long units = Long.parseLong(saved.getProperty("units"));
        long failures = Long.parseLong(saved.getProperty("failures"));
        return new ProofResult(units, failures, figures(saved), examples(saved));
    }

    private static void save(Path file, String commit, ProofResult soFar) throws IOException {
        var saved = new Properties();
        saved.setProperty("commit", commit);
        saved.setProperty("units", Long.toString(soFar.units()));
        saved.setProperty("failures", Long.toString(soFar.failures()));
        for (int i = 0; i < soFar.figures().size(); i++) {
            saveFigure(saved, "figure." + i, soFar.figures().get(i));
        }
        for (int i = 0; i < soFar.examples().size(); i++) {
            saved.setProperty("example." + i, soFar.examples().get(i));
        }
        var text = new StringWriter();
        saved.store(text, null);
        AtomicFile.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
    }

    private static void saveFigure(Properties saved, String key, Figure figure) {
        saved.setProperty(key + ".name", figure.name());
        saved.setProperty(key + ".value", Double.toString(figure.value()));
        saved.setProperty(key + ".unit", figure.unit());
        saved.setProperty(key + ".join", figure.join().name());
    }

    private static List<Figure> figures(Properties saved) {
        var figures = new ArrayList<Figure>();
        for (int i = 0; saved.containsKey("figure." + i + ".name"); i++) {
            String key = "figure." + i;
            figures.add(new Figure(
                    saved.getProperty(key + ".name"),
                    Double.parseDouble(saved.getProperty(key + ".value")),
                    saved.getProperty(key + ".unit"),
                    Figure.Join.valueOf(saved.getProperty(key + ".join"))));
        }
        return figures;
    }

    private static List<String> examples(Properties saved) {
        var examples = new ArrayList<String>();
        for (int i = 0; saved.containsKey("example." + i); i++) {
            examples.add(saved.getProperty("example." + i));
        }
        return examples;
    }
}
