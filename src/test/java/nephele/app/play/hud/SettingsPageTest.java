package nephele.app.play.hud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.sim.state.SimSettings;
import org.junit.jupiter.api.Test;

class SettingsPageTest {
    @Test
    void choosingGoesThroughAllRatesAndAround() {
        var words = new ArrayList<String>();
        var settings = SimSettings.DEFAULT;
        for (int i = 0; i < 6; i++) {
            words.add(SettingsPage.of(settings).entries().get(0).label());
            var choice = assertInstanceOf(
                    Menu.Choice.TurnUpright.class, SettingsPage.of(settings).chosen());
            settings = settings.withUprightDegreesPerSecond(choice.degreesPerSecond());
        }
        assertEquals(
                List.of(
                        "Turn upright: 360°/s",
                        "Turn upright: 720°/s",
                        "Turn upright: at once",
                        "Turn upright: 45°/s",
                        "Turn upright: 90°/s",
                        "Turn upright: 180°/s"),
                words);
        assertEquals(SimSettings.DEFAULT, settings);
    }

    /** A rate from the command line that is not on the page has a next one too. */
    @Test
    void anyRateHasANextOne() {
        var odd = SimSettings.DEFAULT.withUprightDegreesPerSecond(100);
        assertEquals(
                "Turn upright: 100°/s", SettingsPage.of(odd).entries().get(0).label());
        assertEquals(new Menu.Choice.TurnUpright(180), SettingsPage.of(odd).chosen());
    }
}
