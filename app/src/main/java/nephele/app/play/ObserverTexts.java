package nephele.app.play;

import java.util.stream.Collectors;
import java.util.stream.Stream;
import nephele.app.play.hud.HudContent.Banner;
import nephele.app.play.hud.HudContent.Keys;
import nephele.app.settings.Phrase;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.engine.level.Language;
import nephele.engine.level.Level.Observer.Bounds;
import nephele.engine.scene.FrameState.ObserverSphere;
import nephele.host.playthrough.Playthrough;

/** The texts above the picture of an observer: the kind of bounds, whether the sphere touches one, and the keys. */
public final class ObserverTexts {
    private ObserverTexts() {}

    /** Returns the texts of the last frame; {@code null} without an observer. */
    public static Banner banner(Playthrough walk, Keys keys) {
        if (walk.observer() == null) {
            return null;
        }
        Language language = keys.language();
        ObserverSphere sphere = walk.frameState().observer();
        Phrase contact = sphere.touches() ? Phrase.BOUNDS_TOUCHED : Phrase.BOUNDS_APART;
        return new Banner(
                phrase(walk.observer().shown()).in(language) + ": " + contact.in(language),
                movingKeys(keys) + ": " + Phrase.OBSERVER_MOVES.in(language) + "   " + keys.inSentence(Control.PERSON)
                        + ": " + Phrase.BOUNDS_NEXT.in(language));
    }

    private static String movingKeys(Keys keys) {
        return keys.device() == Input.Device.GAMEPAD
                ? "L"
                : Stream.of(Control.FORWARD, Control.LEFT, Control.BACK, Control.RIGHT)
                        .map(keys::inSentence)
                        .collect(Collectors.joining(" "));
    }

    private static Phrase phrase(Bounds bounds) {
        return switch (bounds) {
            case SPHERE -> Phrase.BOUNDS_SPHERE;
            case BOX -> Phrase.BOUNDS_BOX;
            case ORIENTED_BOX -> Phrase.BOUNDS_ORIENTED_BOX;
            case TREE -> Phrase.BOUNDS_TREE;
            case TRIANGLES -> Phrase.BOUNDS_TRIANGLES;
        };
    }
}
