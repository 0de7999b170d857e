package nephele.lab.trade;

import java.awt.image.BufferedImage;

/** All settings of one subject, ready to run in turn. A setting is identified by its index in the trade. */
public interface Experiment extends AutoCloseable {
    Judgement judge(int setting);

    /** Runs the timed work of a setting once; the work is complete when the method returns. */
    void run(int setting);

    /** Returns the exact twin's picture; {@code null} if the subject has no picture. */
    default BufferedImage exact() {
        return null;
    }

    @Override
    default void close() {}
}
