package nephele.lab.prove;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import nephele.lab.prove.proof.Proof;
import nephele.lab.prove.proof.ProofResult;

/** Runs one proof batch by batch from its last state, saves the state after each batch, and shows the progress. */
public final class ProofRun {
    private static final long SHOW_EVERY_NANOS = 2_000_000_000L;

    private final Proof proof;
    private final Path stateFile;
    private final PrintStream progressTo;
    private long lastShownNanos = System.nanoTime();

    public ProofRun(Proof proof, Path stateFolder, PrintStream progressTo) {
        this.proof = proof;
        this.stateFile = stateFolder.resolve(proof.claim().name() + ".properties");
        this.progressTo = progressTo;
    }

    /** Discards the results of earlier runs. */
    public void startOver(String commit) throws IOException {
        ProofState.fresh(commit).save(stateFile);
    }

    /** Runs the missing units until {@code count} are done, and returns the result of all of them. */
    public ProofResult upTo(long count, String commit) throws Exception {
        var state = ProofState.load(stateFile, commit);
        while (state.soFar().units() < count) {
            long from = state.soFar().units();
            long batch = Math.min(proof.claim().batch(), count - from);
            var learnt = proof.run(from, batch, shown(from, count));
            if (learnt.units() != batch) {
                throw new IllegalStateException(proof.claim().name() + " ran " + learnt.units() + " of " + batch + " "
                        + proof.claim().unit());
            }
            state = new ProofState(commit, state.soFar().and(learnt));
            state.save(stateFile);
        }
        return proof.judged(state.soFar());
    }

    private Proof.Progress shown(long from, long count) {
        return new Proof.Progress() {
            @Override
            public void unitsDone(long done) {
                show(from + done, count);
            }

            @Override
            public void failed(String example) {
                progressTo.println(proof.claim().name() + ": failed: " + example);
            }
        };
    }

    /** Runs some units alone without saving the result. */
    public ProofResult alone(long from, long count) throws Exception {
        return proof.judged(proof.run(from, count, shown(0, count)));
    }

    private void show(long done, long count) {
        long now = System.nanoTime();
        if (now - lastShownNanos > SHOW_EVERY_NANOS) {
            lastShownNanos = now;
            progressTo.printf(
                    "%s: %,d of %,d %s%n",
                    proof.claim().name(), done, count, proof.claim().unit());
        }
    }
}
