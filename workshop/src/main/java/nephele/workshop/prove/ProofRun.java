package nephele.workshop.prove;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import nephele.engine.reference.tile.Shard;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Runs one proof batch by batch from its last state, saves the state after each batch, and shows the progress. */
public final class ProofRun {
    private static final long SHOW_EVERY_NANOS = 2_000_000_000L;

    private final Proof proof;
    private final Path stateFolder;
    private final Shard shard;
    private final Path stateFile;
    private final PrintStream progressTo;
    private long lastShownNanos = System.nanoTime();

    public ProofRun(Proof proof, Path stateFolder, PrintStream progressTo) {
        this(proof, stateFolder, Shard.WHOLE, progressTo);
    }

    /** @param shard the share of the units that is run; several processes can run one each */
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

    /** Returns the first unit of the share, after the last one of the share before. */
    private long first() {
        return before(shard.number() - 1);
    }

    private long before(int shares) {
        return shares == 0 ? 0 : proof.claim().fullCount() * shares / shard.of();
    }

    /** Returns the result of this share and of all others that were run at the same commit. */
    public ProofResult joined(String commit) throws IOException {
        ProofResult all = ProofResult.NOTHING;
        for (int number = 1; number <= shard.of(); number++) {
            Path part = stateFile(new Shard(number, shard.of()));
            all = all.and(ProofState.load(part, commit).soFar());
        }
        return proof.judged(all);
    }

    /** Returns how many units the share has. */
    public long size() {
        return before(shard.number()) - first();
    }

    /** Discards the results of earlier runs. */
    public void startOver(String commit) throws IOException {
        ProofState.fresh(commit).save(stateFile);
    }

    /** Runs the missing units until {@code count} of the share are done, and returns the result of all of them. */
    public ProofResult upTo(long count, String commit) throws Exception {
        var state = ProofState.load(stateFile, commit);
        long first = first();
        while (state.soFar().units() < count) {
            long done = state.soFar().units();
            long batch = Math.min(proof.claim().batch(), count - done);
            var learnt = proof.run(first + done, batch, shown(done, count));
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
