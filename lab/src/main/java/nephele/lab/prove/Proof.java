package nephele.lab.prove;

import nephele.engine.terminal.CommandFailure;

/**
 * One claim and the code that tries to refute it. `nephele prove` runs it at the full count in batches and keeps what
 * it learnt after each; a test runs the same code over a small range.
 *
 * <p>A unit is numbered from 0 and depends on its number only (seed the generator with it), so any range can be run
 * alone and a failure can be repeated.
 */
public interface Proof {
    Claim claim();

    /**
     * Runs the units [{@code from}, {@code from + count}) and returns what they showed.
     *
     * @param progress told the number of units of this range that are done, as often as convenient
     * @throws CommandFailure when the environment lacks something; the message says what and how to get it
     */
    ProofResult run(long from, long count, Progress progress) throws Exception;

    /**
     * What the results of all units so far show together; by default, what each of them showed. A claim about more units
     * than a batch has gives their sums as figures and judges these here.
     */
    default ProofResult judged(ProofResult soFar) {
        return soFar;
    }

    /** Listens to a running proof. */
    @FunctionalInterface
    interface Progress {
        Progress NONE = done -> {};

        void unitsDone(long done);

        /** A failure in words, as soon as it is known; the result keeps only the first few. */
        default void failed(String example) {}
    }
}
