package nephele.app.play;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import nephele.app.play.hud.HudContent;
import nephele.app.settings.GameSettings;
import nephele.app.settings.Settings;
import nephele.app.text.Phrase;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.engine.level.Language;
import nephele.engine.playthrough.CrosshairState;
import nephele.engine.playthrough.Playthrough;
import nephele.engine.portal.placement.Refusal;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.TickEvent.Handled;

/**
 * Names the key of an action that is possible now, until the player has done it once. Where none is, it says by how much
 * the ground aimed at is too uneven for a portal: unlike other reasons, that cannot be seen.
 */
final class Prompts {
    /** The actions in the order of their prompts. */
    private static final List<Control> ACTIONS =
            List.of(Control.CARRY, Control.THROW, Control.FIRE_FIRST, Control.FIRE_SECOND);

    private final Set<Control> learned = EnumSet.noneOf(Control.class);
    private Control shownAction;
    private GameSettings shownSettings;
    private Input.Device shownDevice;
    private String shown;
    private long unevenMillimetres;
    private Language unevenIn;
    private String uneven;

    /** Learns what the player did in these events. */
    void after(List<TickEvent> events) {
        for (TickEvent event : events) {
            if (event instanceof TickEvent.PortalOpened opened) {
                learned.add(opened.shot() == GunPortals.Colour.FIRST ? Control.FIRE_FIRST : Control.FIRE_SECOND);
            } else if (event instanceof Handled handled) {
                learn(handled.kind());
            }
        }
    }

    private void learn(Handled.Kind kind) {
        switch (kind) {
            case PICKED_UP -> learned.add(Control.CARRY);
            case THROWN, DROPPED -> learned.add(Control.THROW);
            case LOST, TOO_HEAVY -> {}
        }
    }

    /** Returns the line below the crosshair; null for none. */
    String text(Playthrough playthrough, CrosshairState crosshair, GameSettings settings, Input.Device device) {
        for (int i = 0; i < ACTIONS.size(); i++) {
            Control action = ACTIONS.get(i);
            if (!learned.contains(action) && isPossible(action, playthrough, crosshair)) {
                return shown(action, settings, device);
            }
        }
        long millimetres = unevenMillimetres(crosshair);
        return millimetres == 0 ? null : uneven(millimetres, settings.get(Settings.LANGUAGE));
    }

    private static long unevenMillimetres(CrosshairState crosshair) {
        return crosshair.first() == null
                ? 0
                : Math.max(
                        crosshair.first().unevenMillimetres(),
                        crosshair.second().unevenMillimetres());
    }

    /** Returns the same text while number and language stay the same. */
    private String uneven(long millimetres, Language language) {
        if (unevenMillimetres != millimetres || unevenIn != language) {
            unevenMillimetres = millimetres;
            unevenIn = language;
            uneven = EventText.refusal(Refusal.NOT_FLAT, millimetres, language);
        }
        return uneven;
    }

    /** Returns the same text while action, settings and device stay the same. */
    private String shown(Control action, GameSettings settings, Input.Device device) {
        if (shownAction != action || shownSettings != settings || shownDevice != device) {
            shownDevice = device;
            shownAction = action;
            shownSettings = settings;
            shown = text(action, settings, device);
        }
        return shown;
    }

    private static boolean isPossible(Control action, Playthrough playthrough, CrosshairState crosshair) {
        boolean holds = playthrough.state().world().holding().isHolding();
        return switch (action) {
            case CARRY -> playthrough.canPickUp();
            case THROW -> holds;
            case FIRE_FIRST -> !holds && opens(crosshair.first());
            case FIRE_SECOND -> opens(crosshair.second());
            default -> false;
        };
    }

    private static boolean opens(CrosshairState.Half half) {
        return half != null && half.shot() == CrosshairState.Shot.OPENS;
    }

    private static String text(Control action, GameSettings settings, Input.Device device) {
        Phrase phrase =
                switch (action) {
                    case CARRY -> Phrase.PROMPT_PICK_UP;
                    case THROW -> Phrase.PROMPT_THROW;
                    case FIRE_FIRST -> Phrase.PROMPT_FIRST;
                    default -> Phrase.PROMPT_SECOND;
                };
        var keys = new HudContent.Keys(Settings.bindings(settings), device, settings.get(Settings.LANGUAGE));
        boolean hasKey = !keys.names(action).isEmpty();
        return hasKey ? keys.inSentence(action) + ": " + phrase.in(keys.language()) : null;
    }
}
