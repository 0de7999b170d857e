package nephele.workshop.prove.proof;

import java.util.function.LongSupplier;

/**
 * A claim that a proof tries to refute.
 *
 * @param name as typed after {@code prove}: lower-case words joined by hyphens
 * @param sentence the claim as docs/proofs.md states it
 * @param unit the counted unit, in the plural: "starts", "kills", "seconds"
 * @param needed number of units that the claim needs; evaluated only when the proof runs, because it may depend on the
 *     checkout
 * @param batch number of units between two saves of the state; about a minute's work
 */
public record Claim(String name, String sentence, String unit, LongSupplier needed, long batch) {
    public Claim(String name, String sentence, String unit, long needed, long batch) {
        this(name, sentence, unit, () -> needed, batch);
    }

    /**
     * Returns the number of units that the claim needs.
     *
     * @throws nephele.host.terminal.CommandFailure if the number depends on an environment that is missing
     */
    public long fullCount() {
        return needed.getAsLong();
    }
}
