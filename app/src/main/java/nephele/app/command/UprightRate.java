package nephele.app.command;

import nephele.engine.sim.state.SimSettings;
import nephele.engine.terminal.CommandFailure;

/** Parses the rate of {@code --upright-rate}, in degrees per second. */
final class UprightRate {
    private static final String INSTANT = "instant";

    private UprightRate() {}

    /** @param text {@code null} for the default */
    static int parse(String text) {
        if (text == null) {
            return SimSettings.DEFAULT_UPRIGHT_DEGREES_PER_SECOND;
        }
        if (text.equals(INSTANT)) {
            return SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND;
        }
        int rate = text.matches("[0-9]{1,6}") ? Integer.parseInt(text) : 0;
        if (rate < SimSettings.LEAST_UPRIGHT_DEGREES_PER_SECOND
                || rate > SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND) {
            throw CommandFailure.usage("--upright-rate is `instant` or whole degrees per second from "
                    + SimSettings.LEAST_UPRIGHT_DEGREES_PER_SECOND + " to "
                    + SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND + ", not `" + text + "`");
        }
        return rate;
    }
}
