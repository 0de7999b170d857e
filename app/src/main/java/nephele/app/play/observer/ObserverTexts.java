package nephele.app.play.observer;

import java.util.stream.Collectors;
import java.util.stream.Stream;
import nephele.app.play.hud.HudContent.Banner;
import nephele.app.settings.GameSettings;
import nephele.app.settings.Settings;
import nephele.app.text.Phrase;
import nephele.app.window.Control;
import nephele.engine.level.Language;
import nephele.engine.level.Level.Observer.Bounds;
import nephele.engine.playthrough.Playthrough;
import nephele.engine.scene.FrameState.ObserverSphere;

/** The texts above the picture of an observer: the kind of bounds, whether the sphere touches one, and the keys. */
public final class ObserverTexts {
    private ObserverTexts() {}

    /** Returns the texts of the last frame; {@code null} without an observer. */
    public static Banner banner(Playthrough walk, GameSettings settings) {
        if (walk.observer() == null) {
            return null;
        }
        Language language = settings.get(Settings.LANGUAGE);
        ObserverSphere sphere = walk.frameState().observer();
        Phrase contact = sphere.touches() ? Phrase.BOUNDS_TOUCHED : Phrase.BOUNDS_APART;
        String move = keys(settings, Stream.of(Control.FORWARD, Control.LEFT, Control.BACK, Control.RIGHT), language);
        String next = keys(settings, Stream.of(Control.PERSON), language);
        return new Banner(
                phrase(walk.observer().shown()).in(language) + ": " + contact.in(language),
                move + ": " + Phrase.OBSERVER_MOVES.in(language) + "   " + next + ": "
                        + Phrase.BOUNDS_NEXT.in(language));
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

    private static String keys(GameSettings settings, Stream<Control> controls, Language language) {
        return controls.map(control -> Settings.bindings(settings).keys(control))
                .map(keys -> keys.isEmpty() ? "–" : Phrase.keyName(keys.get(0), language))
                .collect(Collectors.joining(" "));
    }
}
