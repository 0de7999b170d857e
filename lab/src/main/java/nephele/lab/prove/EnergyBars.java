package nephele.lab.prove;

import java.util.Locale;
import java.util.Optional;
import nephele.engine.collision.rigid.BodyTable;
import nephele.engine.sim.PlayerBody;

/**
 * Checks the energy of a pile at every tick against E(t) ≤ least earlier E + 1e-5 · greatest E so far + Σ m g h, for h
 * = 1 cm and for h = 1 mm.
 */
final class EnergyBars {
    private static final double SHARE = 1e-5;
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

    EnergyBars(BodyTable table) {
        double sum = 0;
        for (int i = 0; i < table.size(); i++) {
            sum += table.massKilograms(i) * PlayerBody.GRAVITY;
        }
        weight = sum;
    }

    void start(double joules) {
        least = joules;
        greatest = joules;
    }

    void see(int tick, double joules) {
        greatest = Math.max(greatest, joules);
        double lifted = (joules - least - SHARE * greatest) / weight;
        gainTick = gainTick == 0 && !(lifted <= HEIGHT_METRES) ? tick : gainTick;
        littleTick = littleTick == 0 && !(lifted <= LITTLE_METRES) ? tick : littleTick;
        mostLifted = lifted <= mostLifted ? mostLifted : lifted;
        least = Math.min(least, joules);
    }

    boolean gains() {
        return gainTick > 0;
    }

    boolean gainsLittle() {
        return littleTick > 0;
    }

    double mostLiftedMetres() {
        return mostLifted;
    }

    Optional<String> failure() {
        if (!gainsLittle()) {
            return Optional.empty();
        }
        String bar = gains() ? "1 cm at tick " + gainTick : "1 mm at tick " + littleTick;
        return Optional.of(String.format(
                Locale.ROOT, "gains energy, above the bar of %s, at most %.4g mm of height", bar, mostLifted * 1000));
    }
}
