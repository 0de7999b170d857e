package nephele.workshop.prove.bodies;

import java.util.Locale;
import java.util.Optional;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.sim.state.PlayerDimensions;

/**
 * Checks the energy of a pile at every tick against E(t) ≤ least earlier E + 1e-5 · greatest E so far + Σ m g h, for h
 * = 1 cm and for h = 1 mm.
 */
public final class EnergyLimits {
    private static final double RELATIVE_TOLERANCE = 1e-5;
    private static final double HEIGHT_METRES = .01;
    private static final double LITTLE_METRES = .001;

    /** The weight of all bodies together, in newtons. */
    private final double weight;

    private double least;
    private double greatest;
    private int gainTick;
    private int littleTick;
    /** The greatest height in metres to which the gained energy could lift the pile, less the relative tolerance. */
    private double mostLifted;

    public EnergyLimits(BodyTable table) {
        double sum = 0;
        for (int i = 0; i < table.size(); i++) {
            sum += table.massKilograms(i) * PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED;
        }
        weight = sum;
    }

    public void start(double joules) {
        least = joules;
        greatest = joules;
    }

    public void record(int tick, double joules) {
        greatest = Math.max(greatest, joules);
        double lifted = (joules - least - RELATIVE_TOLERANCE * greatest) / weight;
        gainTick = gainTick == 0 && !(lifted <= HEIGHT_METRES) ? tick : gainTick;
        littleTick = littleTick == 0 && !(lifted <= LITTLE_METRES) ? tick : littleTick;
        mostLifted = lifted <= mostLifted ? mostLifted : lifted;
        least = Math.min(least, joules);
    }

    public boolean gains() {
        return gainTick > 0;
    }

    boolean gainsLittle() {
        return littleTick > 0;
    }

    double mostLiftedMetres() {
        return mostLifted;
    }

    public Optional<String> failure() {
        if (!gainsLittle()) {
            return Optional.empty();
        }
        String bar = gains() ? "1 cm at tick " + gainTick : "1 mm at tick " + littleTick;
        return Optional.of(String.format(
                Locale.ROOT, "gains energy, above the bar of %s, at most %.4g mm of height", bar, mostLifted * 1000));
    }
}
