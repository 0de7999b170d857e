package nephele.lab.trade;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** Advice on the choice of a setting, in sentences computed from a subject's findings. */
final class Advice {
    /** Half an interval's width divided by its middle, above which a cost is called uncertain. */
    private static final double UNCERTAIN = 0.1;

    private final Findings findings;
    private final SettingFindings chosen;

    Advice(Findings findings) {
        this.findings = findings;
        chosen = findings.recommended();
    }

    /** Returns the recommended setting and the reason. */
    String choice() {
        var best = findings.best();
        var cheapest = findings.cheapest();
        String begin = "Choose " + name(chosen) + ": ";
        if (isNoWorse(chosen, best) && Findings.isNoDearer(chosen, cheapest)) {
            return begin + "nothing is clearly cheaper, and nothing errs clearly less.";
        }
        if (isNoWorse(chosen, best)) {
            return begin + "nothing errs clearly less, and what is clearly cheaper errs by more than " + threshold()
                    + " more.";
        }
        return begin + "its error of " + error(chosen.error()) + " is within " + threshold() + " of the best ("
                + name(best) + ", " + error(best.error()) + "), and "
                + (Findings.isNoDearer(best, chosen)
                        ? "nothing is clearly cheaper."
                        : "it costs " + saving(chosen, best) + ".");
    }

    private boolean isNoWorse(SettingFindings a, SettingFindings b) {
        return a.error() <= b.error() + findings.trade().error().step();
    }

    /** Returns further remarks. */
    List<String> remarks() {
        List<String> remarks = new ArrayList<>();
        spread(remarks);
        same(remarks);
        cheaper(remarks);
        usual(remarks);
        dominated(remarks);
        uncertain(remarks);
        return remarks;
    }

    private void spread(List<String> remarks) {
        double worst = findings.settings().stream()
                .mapToDouble(SettingFindings::error)
                .max()
                .orElseThrow();
        double apart = worst - findings.best().error();
        if (apart == 0) {
            remarks.add("The knob does not show here: every setting errs the same.");
        } else if (apart <= enough()) {
            remarks.add(
                    "The knob hardly shows here: between the worst and the best setting lies " + error(apart) + ".");
        }
        if (findings.best().hasPicture() && findings.best().error() > enough()) {
            remarks.add("An error of " + error(findings.best().error())
                    + " is there at the best setting too: it comes from the engine's other approximations.");
        }
    }

    /** Names settings with identical pictures: a driver may support fewer settings than are requested. */
    private void same(List<String> remarks) {
        Map<List<Double>, List<String>> names = new LinkedHashMap<>();
        for (SettingFindings setting : findings.settings()) {
            if (setting.hasPicture()) {
                List<Double> figures = new ArrayList<>(setting.figures());
                figures.add(setting.error());
                names.computeIfAbsent(figures, key -> new ArrayList<>()).add(name(setting));
            }
        }
        names.values().stream()
                .filter(alike -> alike.size() > 1)
                .forEach(alike -> remarks.add(listed(alike) + " give the very same picture here: beyond the first of"
                        + " them the driver or this view offers no more."));
    }

    private static String listed(List<String> names) {
        int last = names.size() - 1;
        return String.join(", ", names.subList(0, last)) + " and " + names.get(last);
    }

    private void cheaper(List<String> remarks) {
        var thrifty = findings.thrifty();
        if (thrifty != chosen && !Findings.isNoDearer(chosen, thrifty)) {
            remarks.add("Where time is short: " + name(thrifty) + " is had for " + saving(thrifty, chosen)
                    + " and errs " + error(thrifty.error()) + " instead of " + error(chosen.error()) + ".");
        }
    }

    private void usual(List<String> remarks) {
        var usual = findings.usual();
        if (usual != chosen) {
            double factor = usual.ratio().estimate() / chosen.ratio().estimate();
            remarks.add("What is usual today, " + name(usual) + ", costs " + Numbers.ratio(factor)
                    + " times as much and errs " + error(usual.error()) + ".");
        }
    }

    private void dominated(List<String> remarks) {
        var never = findings.settings().stream()
                .filter(setting -> !setting.isOnFront())
                .map(setting -> name(setting) + " (" + because(setting) + ")")
                .collect(Collectors.joining(", "));
        remarks.add(never.isEmpty() ? "No setting is dominated." : "Dominated, so never choose: " + never + ".");
    }

    private String because(SettingFindings setting) {
        var by = findings.settings().get(setting.dominatedBy().orElseThrow());
        boolean cheaper = by.ratio().high() < setting.ratio().low();
        boolean better = by.error() < setting.error() - findings.trade().error().step();
        String why = cheaper && better
                ? "costs less and errs less"
                : cheaper ? "costs less and errs no more" : "costs no more and errs less";
        return name(by) + " " + why;
    }

    private void uncertain(List<String> remarks) {
        double widest = findings.settings().stream()
                .mapToDouble(
                        setting -> (setting.ratio().high() - setting.ratio().low())
                                / 2
                                / setting.ratio().estimate())
                .max()
                .orElse(0);
        if (widest > UNCERTAIN) {
            remarks.add("Costs are known to ±" + Numbers.percent(widest)
                    + " only: the machine was busy, or the rounds were few.");
        }
    }

    private static String saving(SettingFindings cheap, SettingFindings dear) {
        double fraction = cheap.ratio().estimate() / dear.ratio().estimate();
        return fraction > 0.995 ? "the same cost" : Numbers.percent(1 - fraction) + " less";
    }

    private double enough() {
        return findings.trade().error().enough();
    }

    private String threshold() {
        return Numbers.chosen(enough(), findings.trade().error().unit());
    }

    private String error(double value) {
        return Numbers.of(value, findings.trade().error().unit());
    }

    private static String name(SettingFindings setting) {
        return "“" + setting.setting().name() + "”";
    }
}
