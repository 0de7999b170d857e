package nephele.lab.trade.subject;

import java.awt.image.BufferedImage;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.Trade;
import nephele.lab.trade.TradeSite;

/** A subject in a level where it matters more than in the one that is reported. */
final class Elsewhere {
    private Elsewhere() {}

    /** @param level of the jar */
    static Trade of(Trade trade, String subject, Trade.Text text, String level) {
        return new Trade(
                subject,
                text,
                trade.qualityFields(),
                trade.settings(),
                trade.usual(),
                trade.error(),
                trade.figures(),
                trade.cost(),
                level,
                site -> new Moved(trade, site.in(level)));
    }

    private record Moved(TradeSite site, Experiment there) implements Experiment {
        Moved(Trade trade, TradeSite site) {
            this(site, trade.experiment().apply(site));
        }

        @Override
        public Judgement judge(int setting) {
            return there.judge(setting);
        }

        @Override
        public void run(int setting) {
            there.run(setting);
        }

        @Override
        public BufferedImage exact() {
            return there.exact();
        }

        @Override
        public void close() {
            there.close();
        }
    }
}
