package nephele.app.play.hud;

import java.util.List;
import nephele.engine.sim.state.SimSettings;

/** The settings page of the menu: choosing a setting changes it to its next value. */
public final class SettingsPage {
    private static final List<Integer> UPRIGHT_RATES =
            List.of(45, 90, 180, 360, 720, SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND);

    private SettingsPage() {}

    public static Menu of(SimSettings now) {
        int rate = now.uprightDegreesPerSecond();
        return new Menu(
                "Settings",
                List.of(
                        new Menu.Entry("Turn upright: " + inWords(rate), new Menu.Choice.TurnUpright(after(rate))),
                        new Menu.Entry("Back", new Menu.Choice.Back())),
                0,
                new Menu.Choice.Back());
    }

    public static String inWords(int uprightDegreesPerSecond) {
        return uprightDegreesPerSecond == SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND
                ? "at once"
                : uprightDegreesPerSecond + "°/s";
    }

    /** Returns the next faster rate, after the fastest the slowest. */
    private static int after(int rate) {
        return UPRIGHT_RATES.stream()
                .filter(faster -> faster > rate)
                .findFirst()
                .orElse(UPRIGHT_RATES.get(0));
    }
}
