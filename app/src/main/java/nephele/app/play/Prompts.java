package nephele.app.play;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import nephele.app.play.hud.HudContent;
import nephele.app.settings.GameSetting;
import nephele.app.settings.GameSettings;
import nephele.app.settings.Phrase;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Settings;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.engine.level.Language;
import nephele.engine.math.Vec3;
import nephele.engine.portal.placement.PlacementResult.Refusal;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.TickEvent.Handled;
import nephele.engine.sim.state.ViewAngles;
import nephele.host.playthrough.CrosshairState;
import nephele.host.playthrough.Playthrough;

/**
 * Names the key of an action that is possible now, until the player has done it once, in whichever level; the player's
 * progress keeps what was done. What a level may not need is named for some seconds only, one after the other. Where no
 * action is named, it says by how much the ground aimed at is too uneven for a portal: unlike other reasons, that
 * cannot be seen.
 */
final class Prompts {
    /** An action, in the order of the prompts; the lower-case name is its word in the file of progress. */
    private enum Verb {
        CARRY(Phrase.PROMPT_PICK_UP, Control.CARRY),
        THROW(Phrase.PROMPT_THROW, Control.THROW),
        FIRE_FIRST(Phrase.PROMPT_FIRST, Control.FIRE_FIRST),
        FIRE_SECOND(Phrase.PROMPT_SECOND, Control.FIRE_SECOND),
        LOOK(Phrase.LOOK, null),
        WALK(Phrase.PROMPT_WALK, Control.FORWARD),
        RUN(Phrase.CONTROL_RUN, Control.RUN),
        JUMP(Phrase.CONTROL_JUMP, Control.JUMP),
        GOAL(Phrase.CONTROL_GOAL, Control.GOAL);

        private final Phrase phrase;
        /** {@code null} for the mouse or a stick. */
        private final Control control;

        Verb(Phrase phrase, Control control) {
            this.phrase = phrase;
            this.control = control;
        }

        private boolean isOptional() {
            return compareTo(RUN) >= 0;
        }
    }

    private static final List<Verb> VERBS = List.of(Verb.values());
    private static final double TURNED_DEGREES = 20;
    private static final double WALKED_METRES = 1.5;
    private static final double FASTER_THAN_WALKING = 4.6;
    private static final double RISING_METRES_PER_SECOND = 2;
    /** A longer way between two frames, of a quarter of a second at most, is a portal's or a restart's. */
    private static final double MOST_STEP_METRES = 1.6;
    /** The time for which an action is named that the level may not need, and that between two of them. */
    private static final double OPTIONAL_SECONDS = 8;

    private static final double REST_SECONDS = 3;

    private final PlayerFiles files;
    private final Set<Verb> learned = EnumSet.noneOf(Verb.class);
    /** How long each action was named in this level. */
    private final double[] shownSeconds = new double[VERBS.size()];

    private double turnedDegrees;
    private double walkedMetres;
    private double restSeconds;
    private Playthrough watched;
    private PlayerState before;
    private long beforeTick;
    private Verb shownVerb;
    private GameSettings shownSettings;
    private Input.Device shownDevice;
    private String shown;
    private long unevenMillimetres;
    private Language unevenIn;
    private String uneven;

    /** @param files keep what was learned */
    Prompts(PlayerFiles files) {
        this.files = files;
        for (Verb verb : VERBS) {
            if (files.progress().hasLearned(GameSetting.word(verb))) {
                learned.add(verb);
            }
        }
    }

    /** Learns what the player did in these events. */
    void after(List<TickEvent> events) {
        for (TickEvent event : events) {
            if (event instanceof TickEvent.PortalOpened opened) {
                learn(opened.shot() == GunPortals.Colour.FIRST ? Verb.FIRE_FIRST : Verb.FIRE_SECOND);
            } else if (event instanceof Handled handled) {
                learn(handled.kind());
            }
        }
    }

    private void learn(Handled.Kind kind) {
        switch (kind) {
            case PICKED_UP -> learn(Verb.CARRY);
            case THROWN, DROPPED -> learn(Verb.THROW);
            case LOST, TOO_HEAVY -> {}
        }
    }

    /** Learns that the goal was looked at. */
    void goalShown() {
        learn(Verb.GOAL);
    }

    private void learn(Verb verb) {
        if (learned.add(verb)) {
            files.keep(files.progress().withLearned(GameSetting.word(verb)));
        }
    }

    /** Returns the line below the crosshair; null for none. */
    String text(Playthrough playthrough, CrosshairState crosshair, GameSettings settings, Input.Device device) {
        double seconds = watch(playthrough);
        Verb verb = named(playthrough, crosshair, false);
        if (verb == null && unevenMillimetres(crosshair) != 0) {
            return uneven(unevenMillimetres(crosshair), settings.get(Settings.LANGUAGE));
        } else if (verb == null && learned.contains(Verb.WALK)) {
            verb = optional(playthrough, crosshair, seconds);
        }
        return verb == null ? null : shown(verb, settings, device);
    }

    private Verb named(Playthrough playthrough, CrosshairState crosshair, boolean optional) {
        for (int i = 0; i < VERBS.size(); i++) {
            Verb verb = VERBS.get(i);
            boolean isMeant =
                    verb.isOptional() == optional && !learned.contains(verb) && shownSeconds[i] < OPTIONAL_SECONDS;
            if (isMeant && isPossible(verb, playthrough, crosshair)) {
                return verb;
            }
        }
        return null;
    }

    /** Names one action for some seconds, then none for some. */
    private Verb optional(Playthrough playthrough, CrosshairState crosshair, double seconds) {
        restSeconds -= seconds;
        Verb verb = restSeconds > 0 ? null : named(playthrough, crosshair, true);
        if (verb != null) {
            shownSeconds[verb.ordinal()] += seconds;
            restSeconds = shownSeconds[verb.ordinal()] < OPTIONAL_SECONDS ? restSeconds : REST_SECONDS;
        }
        return verb;
    }

    /** Learns from how the player moved since the last frame. Returns the simulated time since then. */
    private double watch(Playthrough playthrough) {
        PlayerState now = playthrough.state().player();
        long tick = playthrough.state().tick();
        if (watched != playthrough) {
            watched = playthrough;
            Arrays.fill(shownSeconds, 0);
            restSeconds = REST_SECONDS;
        } else if (now != before) {
            turned(before.heading(), now.heading());
            moved(before, now);
        }
        double seconds = Math.max(0, tick - beforeTick) * playthrough.secondsPerTick();
        before = now;
        beforeTick = tick;
        return seconds;
    }

    private void turned(ViewAngles from, ViewAngles to) {
        turnedDegrees += Math.abs(Math.toDegrees(from.yawRadiansTo(to)))
                + Math.abs(from.pitchMillidegrees() - to.pitchMillidegrees()) / 1000.0;
        if (turnedDegrees > TURNED_DEGREES) {
            learn(Verb.LOOK);
        }
    }

    private void moved(PlayerState from, PlayerState to) {
        Vec3 displacement = to.feet().minus(from.feet());
        double metres = Math.hypot(displacement.x(), displacement.z());
        walkedMetres += metres < MOST_STEP_METRES ? metres : 0;
        if (walkedMetres > WALKED_METRES) {
            learn(Verb.WALK);
        }
        boolean isFast = Math.hypot(to.velocity().x(), to.velocity().z()) > FASTER_THAN_WALKING;
        if (isFast && from.isGrounded() && to.isGrounded()) {
            learn(Verb.RUN);
        }
        if (from.isGrounded() && !to.isGrounded() && to.velocity().y() > RISING_METRES_PER_SECOND) {
            learn(Verb.JUMP);
        }
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
            uneven = Message.ofRefusal(Refusal.NOT_FLAT, millimetres, language);
        }
        return uneven;
    }

    /** Returns the same text while action, settings and device stay the same. */
    private String shown(Verb verb, GameSettings settings, Input.Device device) {
        if (shownVerb != verb || shownSettings != settings || shownDevice != device) {
            shownDevice = device;
            shownVerb = verb;
            shownSettings = settings;
            shown = text(verb, settings, device);
        }
        return shown;
    }

    private static boolean isPossible(Verb verb, Playthrough playthrough, CrosshairState crosshair) {
        boolean holds = playthrough.state().world().holding().isHolding();
        return switch (verb) {
            case CARRY -> playthrough.canPickUp();
            case THROW -> holds;
            case FIRE_FIRST -> !holds && opens(crosshair.first());
            case FIRE_SECOND -> opens(crosshair.second());
            case LOOK, WALK, RUN, JUMP, GOAL -> true;
        };
    }

    private static boolean opens(CrosshairState.Half half) {
        return half != null && half.shot() == CrosshairState.Shot.OPENS;
    }

    private static String text(Verb verb, GameSettings settings, Input.Device device) {
        var keys = new HudContent.Keys(Settings.bindings(settings), device, settings.get(Settings.LANGUAGE));
        String names =
                switch (verb) {
                    case LOOK -> keys.look();
                    case WALK -> keys.walk();
                    default -> keys.names(verb.control).isEmpty() ? "" : keys.inSentence(verb.control);
                };
        return names.isEmpty()
                ? null
                : Character.toUpperCase(names.charAt(0)) + names.substring(1) + ": " + verb.phrase.in(keys.language());
    }
}
