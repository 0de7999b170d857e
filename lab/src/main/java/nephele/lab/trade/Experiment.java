package nephele.lab.trade;

import java.awt.image.BufferedImage;

/** All settings of one subject, ready to run side by side. Settings are named by their index in the trade. */
public interface Experiment extends AutoCloseable {
    Judgement judge(int setting);

    /** Does once what is timed, complete when it returns. */
    void run(int setting);

    /** What the exact twin shows; {@code null} where there is nothing to see. */
    default BufferedImage exact() {
        return null;
    }

    @Override
    default void close() {}
}
