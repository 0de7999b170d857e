package nephele.app.trade;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import nephele.engine.measure.Interval;
import nephele.engine.measure.PairedBootstrap;
import nephele.engine.measure.ParetoFront;

/** What a subject's measurements say. */
public record Findings(Trade trade, List<SettingFindings> settings, int rounds) {
    public static Findings of(Trade trade, SubjectState state) {
        var bootstrap = PairedBootstrap.standard();
        int count = trade.settings().size();
        List<Interval> ratios = new ArrayList<>();
        double[] usual = column(state, trade.usual(), Cost::cpuNanos);
        for (int i = 0; i < count; i++) {
            ratios.add(bootstrap.ratio(usual, column(state, i, Cost::cpuNanos)));
        }
        var front = new ParetoFront(
                IntStream.range(0, count)
                        .mapToObj(i -> new ParetoFront.Choice(
                                ratios.get(i), state.judged().get(i).error()))
                        .toList(),
                trade.error().step());
        List<SettingFindings> settings = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            var judged = state.judged().get(i);
            settings.add(new SettingFindings(
                    trade.settings().get(i),
                    scaled(
                            bootstrap.median(column(state, i, Cost::cpuNanos)),
                            trade.cost().scale()),
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

    /** The cheapest setting on the front among those that err by no more than is enough above the best. */
    public SettingFindings recommended() {
        double best = best().error();
        return settings.stream()
                .filter(SettingFindings::isOnFront)
                .filter(setting -> setting.error() <= best + trade.error().enough())
                .reduce((a, b) -> b.ratio().estimate() < a.ratio().estimate() ? b : a)
                .orElseThrow();
    }

    /** The setting with the least error; it is on the front. */
    public SettingFindings best() {
        return settings.stream()
                .filter(SettingFindings::isOnFront)
                .reduce((a, b) -> b.error() < a.error() ? b : a)
                .orElseThrow();
    }

    public SettingFindings cheapest() {
        return settings.stream()
                .filter(SettingFindings::isOnFront)
                .reduce((a, b) -> b.ratio().estimate() < a.ratio().estimate() ? b : a)
                .orElseThrow();
    }
}
