package nephele.lab.prove;

import java.util.function.LongSupplier;

/**
 * What a proof would refute.
 *
 * @param name what is typed after `prove`: lower-case words joined by hyphens
 * @param sentence the claim as docs/proofs.md states it
 * @param unit what is counted, in the plural: "starts", "kills", "seconds"
 * @param needed how many units the claim needs; asked for only when the proof runs, because it may depend on the checkout
 * @param batch how many units run between two saves of the state; a minute's work is a good size
 */
public record Claim(String name, String sentence, String unit, LongSupplier needed, long batch) {
    public Claim(String name, String sentence, String unit, long needed, long batch) {
        this(name, sentence, unit, () -> needed, batch);
    }

    /**
     * How many units the claim needs.
     *
     * @throws nephele.engine.terminal.CommandFailure when the environment, which says how many, lacks them
     */
    public long fullCount() {
        return needed.getAsLong();
    }
}
