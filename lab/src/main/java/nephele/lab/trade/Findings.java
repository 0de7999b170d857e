package nephele.lab.trade;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import nephele.engine.measure.Interval;
import nephele.engine.measure.PairedBootstrap;
import nephele.engine.measure.ParetoFront;

/** What a subject's measurements say. */
public record Findings(Trade trade, List<SettingFindings> settings, int rounds) {
    /** Costs that differ by less, as a share, are not called different: other work shifts even equal ones so far. */
    public static final double COST_STEP = 0.03;

    public static Findings of(Trade trade, SubjectState state) {
        var bootstrap = PairedBootstrap.standard();
        int count = trade.settings().size();
        List<Interval> ratios = new ArrayList<>();
        double usualCost = trade.cost().scale()
                * bootstrap.median(column(state, trade.usual(), Cost::cpuNanos)).estimate();
        double[] usual = column(state, trade.usual(), Cost::cpuNanos);
        for (int i = 0; i < count; i++) {
            ratios.add(bootstrap.ratio(usual, column(state, i, Cost::cpuNanos)));
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
                    bootstrap.median(column(state, i, Cost::wallNanos)),
                    ratios.get(i),
                    bootstrap.median(column(state, i, Cost::bytes)).estimate()
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
     * Among those on the front that err by no more than is enough above the best: the usual one unless another is cheaper
     * beyond doubt, else the most accurate of those that are not dearer than the cheapest beyond doubt.
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

    /** Whether nothing speaks for the first being dearer than the second. */
    public static boolean isNoDearer(SettingFindings a, SettingFindings b) {
        return a.ratio().low() * (1 - COST_STEP) <= b.ratio().high();
    }

    private static SettingFindings moreAccurate(SettingFindings a, SettingFindings b) {
        boolean better = b.error() < a.error()
                || b.error() == a.error() && b.cost().estimate() < a.cost().estimate();
        return better ? b : a;
    }

    /** The setting with the least error; it is on the front. */
    public SettingFindings best() {
        return settings.stream()
                .filter(SettingFindings::isOnFront)
                .reduce((a, b) -> b.error() < a.error() ? b : a)
                .orElseThrow();
    }

    /**
     * What one chooses whose time is short: the cheapest of those on the front that err by no more than half as much again as
     * the best, and what is enough.
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
