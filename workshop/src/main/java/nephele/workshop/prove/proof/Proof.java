package nephele.workshop.prove.proof;

import nephele.host.terminal.CommandFailure;

/**
 * A claim and the code that tries to refute it. {@code nephele prove} runs the full count in batches and saves the
 * results after each; a test runs the same code over a small range.
 *
 * <p>Units are numbered from 0, and a unit depends only on its number (which seeds the generator), so that any range
 * can be run alone and a failure can be repeated.
 */
public interface Proof {
    Claim claim();

    /**
     * Runs the units [{@code from}, {@code from + count}) and returns their result.
     *
     * @param progress receives the number of units of this range that are done, as often as convenient
     * @throws CommandFailure if the environment lacks something; the message says what and how to get it
     */
    ProofResult run(long from, long count, Progress progress) throws Exception;

    /**
     * Returns the result of all units so far. By default it is their joined result; a claim about more units than a
     * batch has gives sums as figures and judges them here.
     */
    default ProofResult judged(ProofResult soFar) {
        return soFar;
    }

    /** Receives the progress of a running proof. */
    @FunctionalInterface
    interface Progress {
        Progress NONE = done -> {};

        void unitsDone(long done);

        /** Receives a failure in words as soon as it is found; the result keeps only the first few. */
        default void failed(String example) {}
    }
}
