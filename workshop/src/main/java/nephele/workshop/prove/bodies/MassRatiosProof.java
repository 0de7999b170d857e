package nephele.workshop.prove.bodies;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.level.Body;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Loads light cubes with heavy ones. A unit is one of three stacks at one of three tick rates. */
public final class MassRatiosProof implements Proof {
    private static final int[] RATES = {30, 60, 1000};
    private static final List<Stack> STACKS = List.of(
            new Stack("1 t on 1 g", LoadedStack.tonneOnGram()),
            new Stack("tower of ratio 2", LoadedStack.tower(2)),
            new Stack("tower of ratio 3.16", LoadedStack.tower(3.16)));

    private final double seconds;

    private record Stack(String name, List<Body> bodies) {}

    /** @param seconds for which each stack carries its load */
    public MassRatiosProof(double seconds) {
        this.seconds = seconds;
    }

    @Override
    public Claim claim() {
        return new Claim(
                "mass-ratios",
                "A tonne on a gram, and towers of twelve cubes each 2 or 3.16 times as heavy as the one below, at 30,"
                        + " 60 and 1000 ticks a second: none sleeps more than 1 mm in the floor or in another, none is"
                        + " faster than 5 m/s, and the lowest is out of the floor within 1 s after the others are taken"
                        + " away.",
                "stacks",
                (long) RATES.length * STACKS.size(),
                (long) RATES.length * STACKS.size());
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        ProofResult result = ProofResult.NOTHING;
        for (long unit = from; unit < from + count; unit++) {
            Stack stack = STACKS.get((int) (unit / RATES.length));
            result = result.and(seen(stack, RATES[(int) (unit % RATES.length)]));
            progress.unitsDone(unit + 1 - from);
        }
        return result;
    }

    private ProofResult seen(Stack stack, int rate) {
        LoadedStack.Seen seen = LoadedStack.run(stack.bodies(), rate, seconds);
        List<String> failures = new ArrayList<>();
        if (!seen.holds()) {
            failures.add(String.format(
                    Locale.ROOT,
                    "%s at %d ticks/s: sleeps %.3f mm deep, moves at %.3f m/s, is %.3f mm in the floor unloaded",
                    stack.name(),
                    rate,
                    seen.sleepsDeepMetres() * 1000,
                    seen.fastestMetresPerSecond(),
                    seen.sunkMetres() * 1000));
        }
        List<Figure> figures = List.of(
                Figure.greatest(stack.name() + ", sleeps deep", seen.sleepsDeepMetres() * 1000, "mm"),
                Figure.greatest(stack.name() + ", fastest", seen.fastestMetresPerSecond(), "m/s"),
                Figure.greatest(stack.name() + ", unloaded, in the floor", seen.sunkMetres() * 1000, "mm"));
        return ProofResult.of(1, failures, figures);
    }
}
