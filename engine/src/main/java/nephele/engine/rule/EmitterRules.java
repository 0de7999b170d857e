package nephele.engine.rule;

import java.util.List;
import nephele.engine.level.Emitter;
import nephele.engine.level.Problem;
import nephele.engine.level.placed.LevelRule;

/** Rules for emitters that make too much, or less than their author expects. */
final class EmitterRules {
    static final LevelRule COUNT = LevelRule.ofRecords((level, report) -> {
        List<Emitter> emitters = level.emitters();
        double sum = 0;
        for (int i = 0; i < emitters.size(); i++) {
            sum += emitters.get(i).mostAtOnce();
            if (sum > Emitter.MOST_PARTICLES) {
                report.accept(Problem.error(
                        "emitters[" + i + "].ratePerSecond",
                        "a level shows at most " + Emitter.MOST_PARTICLES + " particles at once: lower the rates"));
                return;
            }
        }
    });

    static final LevelRule USED = LevelRule.ofRecords((level, report) -> LevelRule.each("emitters", level.emitters(), (path, emitter) -> {
                double repeat = emitter.repeatSeconds();
                boolean explodes = emitter.kind() == Emitter.Kind.EXPLOSION;
                if (explodes && repeat > 0 && repeat < emitter.longestLifeSeconds()) {
                    report.accept(Problem.error(
                            path + ".repeatSeconds",
                            "an explosion lasts " + emitter.longestLifeSeconds()
                                    + " s: repeat it later, or give 0 for one explosion"));
                } else if (!explodes && repeat > 0) {
                    report.accept(
                            Problem.warning(path + ".repeatSeconds", "only an explosion is repeated: leave it out"));
                }
                if (emitter.splashes() && emitter.kind() != Emitter.Kind.RAIN) {
                    report.accept(Problem.warning(path + ".splashes", "only rain splashes: leave it out"));
                }
                if (emitter.ratePerSecond() == 0) {
                    report.accept(Problem.warning(
                            path + ".ratePerSecond", "with a rate of 0 nothing is shown: give it a rate"));
                }
            }));

    private EmitterRules() {}
}
