package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import nephele.app.play.hud.HudContent;
import nephele.app.settings.GameSettings;
import nephele.app.settings.Settings;
import nephele.app.window.Input;
import nephele.engine.level.Hint;
import nephele.engine.level.Language;
import nephele.engine.level.Place;
import nephele.engine.math.Vec3;
import nephele.host.playthrough.HintClock;
import org.junit.jupiter.api.Test;

/** What a player reads who asks for hints too early, in time and again, and what is read when lines come together. */
class GivenHintsTest {
    private static final Place FAR = new Place(new Vec3(100, 0, 0), 2);

    private final HintClock clock = new HintClock(
            List.of(hint("Look up.", 60, null), hint("Jump.", 100, null), hint("Swim.", 5, FAR)), 1 / 120.0);
    private double seconds;
    private final Message message = new Message(() -> Language.EN, () -> (long) (seconds * 1e9));
    private final GivenHints hints = new GivenHints(
            message,
            () -> new HudContent.Keys(Settings.bindings(GameSettings.DEFAULT), Input.Device.KEYBOARD, Language.EN));

    private static Hint hint(String text, double afterSeconds, Place near) {
        return new Hint(text, Map.of(Language.EN, text), afterSeconds, near);
    }

    /** Plays until a time. */
    private void playTo(double end) {
        while (seconds < end) {
            clock.tick(Vec3.ZERO);
            seconds += 1 / 120.0;
            hints.offer(clock, seconds);
            message.texts();
        }
    }

    @Test
    void whoAsksTooEarlyHearsWhenAHintComesAndThenHasIt() {
        playTo(20);
        hints.give(clock);
        assertEquals(List.of("A hint comes in 40 s"), message.texts());
        playTo(35);
        assertEquals(List.of(), message.texts());
        playTo(61);
        assertEquals(List.of("Hint 1 of 3: Look up."), message.texts(), "it comes without another key");
        playTo(70);
        hints.give(clock);
        assertEquals(List.of("Hint 1 of 3: Look up. (the next one in 30 s)"), message.texts());
        assertEquals(1, clock.given());
    }

    @Test
    void aHintThatWouldBeOfferedInAMomentIsGivenAtOnce() {
        playTo(51);
        hints.give(clock);
        assertEquals(List.of("Hint 1 of 3: Look up."), message.texts());
        playTo(62);
        assertEquals(List.of(), message.texts(), "and is not offered afterwards");
    }

    @Test
    void whoDoesNotAskIsOfferedOneAtATime() {
        playTo(61);
        assertEquals(List.of("H: a hint, if you are stuck"), message.texts());
        playTo(101);
        hints.give(clock);
        playTo(102);
        assertEquals(List.of("Hint 1 of 3: Look up."), message.texts(), "the next offer waits until it is read");
        playTo(107);
        assertEquals(List.of("H: a hint, if you are stuck"), message.texts());
        hints.give(clock);
        assertEquals(List.of("Hint 2 of 3: Jump."), message.texts());
        hints.give(clock);
        assertEquals(List.of("Hint 2 of 3: Jump."), message.texts(), "the third one is elsewhere");
    }

    @Test
    void longTimesAreToldInMinutes() {
        HintClock late = new HintClock(List.of(hint("Wait.", 600, null)), 1 / 120.0);
        late.tick(Vec3.ZERO);
        hints.give(late);
        assertEquals(List.of("A hint comes in 10 min"), message.texts());
    }

    @Test
    void whereNoneComesTheLineSaysSo() {
        hints.give(new HintClock(List.of(), 1 / 120.0));
        assertEquals(List.of("This level has no hints"), message.texts());
        HintClock elsewhere = new HintClock(List.of(hint("Swim.", 5, FAR)), 1 / 120.0);
        elsewhere.tick(Vec3.ZERO);
        hints.give(elsewhere);
        assertEquals(List.of("No hint for this place: look around"), message.texts());
    }

    /** A hint stays the lowest line, which every window shows, and takes asides away. */
    @Test
    void otherLinesDoNotPushAHintAway() {
        message.sayAside("It is slow.");
        message.sayHint("Hint: jump.");
        assertEquals(List.of("Hint: jump."), message.texts());
        for (String line : List.of("one", "two", "three", "four")) {
            message.say(line);
        }
        assertEquals(List.of("three", "four", "Hint: jump."), message.texts());
        message.sayHint("Hint: look.");
        assertEquals(List.of("three", "four", "Hint: look."), message.texts());
    }
}
