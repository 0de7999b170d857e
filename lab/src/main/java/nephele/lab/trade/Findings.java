package nephele.lab.trade;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import nephele.engine.measure.Interval;
import nephele.engine.measure.ParetoFront;

/** The evaluated measurements of a subject. */
public record Findings(Trade trade, List<SettingFindings> settings, int rounds) {
    /**
     * The relative difference below which two costs count as equal: other work on the machine shifts even equal costs
     * by as much.
     */
    public static final double COST_STEP = 0.03;

    public static Findings of(Trade trade, SubjectState state) {
        int count = trade.settings().size();
        List<Interval> ratios = new ArrayList<>();
        double usualCost = trade.cost().scale()
                * Interval.ofMedian(column(state, trade.usual(), Cost::cpuNanos))
                        .estimate();
        double[] usual = column(state, trade.usual(), Cost::cpuNanos);
        for (int i = 0; i < count; i++) {
            ratios.add(Interval.ofRatio(usual, column(state, i, Cost::cpuNanos)));
        }
        var front = new ParetoFront(
                IntStream.range(0, count)
                        .mapToObj(i -> new ParetoFront.Choice(
                                ratios.get(i), state.judged().get(i).error()))
                        .toList(),
                trade.error().step(),
                COST_STEP);
        List<SettingFindings> settings = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            var judged = state.judged().get(i);
            settings.add(new SettingFindings(
                    trade.settings().get(i),
                    scaled(ratios.get(i), usualCost),
                    Interval.ofMedian(column(state, i, Cost::wallNanos)),
                    ratios.get(i),
                    Interval.ofMedian(column(state, i, Cost::bytes)).estimate()
                            / trade.cost().perRun(),
                    judged.error(),
                    judged.figures(),
                    judged.hasPicture(),
                    front.dominating(i)));
        }
        return new Findings(trade, List.copyOf(settings), state.rounds().size());
    }

    private static double[] column(SubjectState state, int setting, ToDoubleFunction<Cost> value) {
        return state.rounds().stream()
                .mapToDouble(round -> value.applyAsDouble(round.get(setting)))
                .toArray();
    }

    private static Interval scaled(Interval interval, double by) {
        return new Interval(interval.low() * by, interval.estimate() * by, interval.high() * by);
    }

    public SettingFindings usual() {
        return settings.get(trade.usual());
    }

    /**
     * Returns the recommended setting. The candidates are on the Pareto front and have an error at most {@code enough}
     * above the best. The usual setting is recommended unless another is cheaper beyond doubt; otherwise the most
     * accurate of the candidates that are not dearer beyond doubt than the cheapest.
     */
    public SettingFindings recommended() {
        double most = best().error() + trade.error().enough();
        List<SettingFindings> candidates = settings.stream()
                .filter(setting -> setting.isOnFront() && setting.error() <= most)
                .toList();
        SettingFindings cheapest = candidates.stream()
                .reduce((a, b) -> b.ratio().high() < a.ratio().high() ? b : a)
                .orElseThrow();
        List<SettingFindings> cheap = candidates.stream()
                .filter(setting -> isNoDearer(setting, cheapest))
                .toList();
        return cheap.contains(usual())
                ? usual()
                : cheap.stream().reduce(Findings::moreAccurate).orElseThrow();
    }

    /** Returns true if the intervals do not show that the first setting is dearer than the second. */
    public static boolean isNoDearer(SettingFindings a, SettingFindings b) {
        return a.ratio().low() * (1 - COST_STEP) <= b.ratio().high();
    }

    private static SettingFindings moreAccurate(SettingFindings a, SettingFindings b) {
        boolean better = b.error() < a.error()
                || b.error() == a.error() && b.cost().estimate() < a.cost().estimate();
        return better ? b : a;
    }

    /** Returns the setting with the least error; it is on the front. */
    public SettingFindings best() {
        return settings.stream()
                .filter(SettingFindings::isOnFront)
                .reduce((a, b) -> b.error() < a.error() ? b : a)
                .orElseThrow();
    }

    /**
     * Returns a setting for use under time pressure: the cheapest on the front with an error of at most 1.5 times the
     * best error plus {@code enough}.
     */
    public SettingFindings thrifty() {
        double most = 1.5 * best().error() + trade.error().enough();
        return settings.stream()
                .filter(setting -> setting.isOnFront() && setting.error() <= most)
                .reduce((a, b) -> b.ratio().estimate() < a.ratio().estimate() ? b : a)
                .orElseThrow();
    }

    public SettingFindings cheapest() {
        return settings.stream()
                .filter(SettingFindings::isOnFront)
                .reduce((a, b) -> b.ratio().estimate() < a.ratio().estimate() ? b : a)
                .orElseThrow();
    }
}
