package nephele.app.command;

import nephele.engine.sim.state.SimSettings;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** The rate of {@code --upright-rate}. */
record UprightRate(int degreesPerSecond) {
    static final UprightRate USUAL = new UprightRate(SimSettings.DEFAULT_UPRIGHT_DEGREES_PER_SECOND);

    private static final String INSTANT = "instant";

    /** Reads whole degrees per second, or {@code instant}. */
    static final class Converter implements ITypeConverter<UprightRate> {
        @Override
        public UprightRate convert(String text) {
            if (text.equals(INSTANT)) {
                return new UprightRate(SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND);
            }
            int rate = text.matches("[0-9]{1,6}") ? Integer.parseInt(text) : 0;
            if (rate < SimSettings.LEAST_UPRIGHT_DEGREES_PER_SECOND
                    || rate > SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND) {
                throw new TypeConversionException("'" + text + "' must be `instant` or whole degrees per second from "
                        + SimSettings.LEAST_UPRIGHT_DEGREES_PER_SECOND + " to "
                        + SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND);
            }
            return new UprightRate(rate);
        }
    }
}
