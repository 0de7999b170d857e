package nephele.app.play;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import nephele.app.play.hud.Area;
import nephele.app.play.hud.HudContent;
import nephele.app.play.hud.HudContent.Banner;
import nephele.app.play.hud.HudContent.Keys;
import nephele.app.play.hud.HudContent.Page;
import nephele.app.settings.GameSettings;
import nephele.app.settings.Phrase;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Settings;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.app.window.KeyBindings;
import nephele.engine.level.Language;
import nephele.engine.model.bound.Bound;
import nephele.engine.scene.FrameState.ObserverSphere;
import nephele.engine.sim.state.TickEvent;
import nephele.host.named.LevelTitles;
import nephele.host.playthrough.Playthrough;

/** Draws a frame of the game: the level as the stage shows it, and the overlay above it. */
final class GamePicture {
    /** The time for which the goal stays after its key, so that who taps the key can read it. */
    private static final long GOAL_NANOS = 3_000_000_000L;

    private final Display display;
    private final CurrentLevel current;
    private final MenuControl menu;
    private final Message message;
    private final PlayerFiles files;
    private final Captions captions;
    private final Prompts prompts;
    private final GivenHints hints;
    private final ComparisonTexts comparisonTexts = new ComparisonTexts();
    private long titleNanos;
    private boolean wasGoalAsked;
    private long goalNanos;
    private final Input input;
    private final WipeControl wipe;
    private GameSettings keysOf;
    private HudContent.Keys keys;

    GamePicture(
            Display display,
            CurrentLevel current,
            MenuControl menu,
            Message message,
            PlayerFiles files,
            Input input,
            LevelTitles titles) {
        captions = new Captions(titles);
        this.display = display;
        this.current = current;
        this.menu = menu;
        this.message = message;
        this.files = files;
        this.input = input;
        wipe = new WipeControl(input);
        prompts = new Prompts(files);
        hints = new GivenHints(message, this::keys);
    }

    /** Says a hint that the player asked for. */
    void giveHint() {
        if (current.session().isInPlayersHands()) {
            hints.give(current.session().walk());
        }
    }

    /** Starts the motion behind the title. */
    void titleOpens() {
        titleNanos = System.nanoTime();
    }

    /** Learns what the player did. */
    void after(List<TickEvent> events) {
        prompts.after(events);
    }

    /** Shows the aim of the current level for its first seconds. */
    void levelBegins() {
        captions.begin(current.session());
        wasGoalAsked = false;
        hints.restart();
        keysOf = null;
        if (isCompared()) {
            message.say("← →  " + keys().withRun(Phrase.MOVE_WIPE));
        }
    }

    /** Forgets the level, so that nothing keeps its memory. */
    void levelEnds() {
        captions.begin(null);
    }

    /** Draws what the window waits for until the level's first frame, which computes tables of its sky. */
    void announce() {
        Language language = files.settings().get(Settings.LANGUAGE);
        Banner banner = captions.preparing(current.session().request().level(), language);
        display.drawEmpty(
                new HudContent(null, Page.NONE, List.of(), message.texts(), banner, null, null, keys(), null),
                Display.Shot.NONE);
    }

    /**
     * Draws a frame.
     *
     * @param loading the level that is being loaded; null if none is
     */
    void draw(GameStage stage, Loading loading, Page page, Display.Shot shot) {
        Session session = current.session();
        if (session == null) {
            display.drawEmpty(
                    new HudContent(
                            menu.page(),
                            page,
                            List.of(),
                            message.texts(),
                            banner(stage, loading),
                            null,
                            null,
                            keys(),
                            null),
                    shot);
            return;
        }
        var area = display.area();
        boolean isPlaying = stage == GameStage.RUNNING;
        if (isPlaying && session.isInPlayersHands()) {
            hints.offer(session.walk());
        }
        var content = new HudContent(
                menu.page(),
                page,
                current.figureLines(keys().language()),
                message.texts(),
                banner(stage, loading),
                isPlaying && session.walk().observer() == null ? sight(session, area) : null,
                comparison(session),
                keys(),
                page == Page.HELP && stage != GameStage.TITLE ? captions.goal(session, keys().language()) : null);
        var listener = current.figures().frameBegins();
        boolean isKept = stage == GameStage.TITLE && display.keepsTitle();
        if (isKept) {
            display.drawTitle(session, content, shot, menu.rests());
        } else if (stage == GameStage.TITLE) {
            display.drawTitle(session, titleSeconds(), content, listener, shot);
        } else {
            display.draw(session, content, listener, shot);
        }
        current.figures().frameEnds(session.walk(), keys().language());
        if (shot == Display.Shot.NONE && !isKept) { // a frame with a screenshot waits for a file
            current.frameCost(display.costMillis(), display.pixels());
        }
    }

    /** Moves the wipe by the keys since the last frame, whose length is in seconds. */
    void moveWipe(GameStage stage, double seconds) {
        if (stage == GameStage.RUNNING && isCompared()) {
            wipe.update(seconds);
        } else {
            wipe.rest();
        }
    }

    private boolean isCompared() {
        return current.session().picture().comparison() != null;
    }

    private HudContent.Comparison comparison(Session session) {
        var compared = session.picture().comparison();
        return compared == null
                ? null
                : comparisonTexts.of(compared, wipe.wipe(), files.settings().get(Settings.LANGUAGE));
    }

    private HudContent.Keys keys() {
        if (keysOf != files.settings() || keys.device() != input.device()) {
            keysOf = files.settings();
            KeyBindings all = Settings.bindings(keysOf);
            boolean hasWipe = current.session() != null && isCompared();
            keys = new HudContent.Keys(
                    hasWipe ? all.without(WipeControl.KEYS) : all, input.device(), keysOf.get(Settings.LANGUAGE));
        }
        return keys;
    }

    private HudContent.Sight sight(Session session, Area area) {
        var crosshair = session.walk().sights(area.width(), area.height());
        return new HudContent.Sight(
                crosshair,
                files.settings().get(Settings.PORTAL_COLOURS),
                session.isInPlayersHands()
                        ? prompts.text(session.walk(), crosshair, files.settings(), input.device())
                        : null,
                showsGoal() ? Captions.goalMark(session.level(), session.walk().view(display.aspect()), area) : null);
    }

    private boolean showsGoal() {
        if (input.takeHold(Control.GOAL)) {
            wasGoalAsked = true;
            goalNanos = System.nanoTime();
        }
        return wasGoalAsked && System.nanoTime() - goalNanos < GOAL_NANOS;
    }

    private double titleSeconds() {
        return (System.nanoTime() - titleNanos) / 1e9;
    }

    private Banner running(Language language) {
        if (showsGoal()) {
            prompts.goalShown();
            return captions.goal(current.session(), language);
        }
        Banner aim = captions.aim(language);
        return aim != null ? aim : observerBanner(current.session().walk(), keys());
    }

    private Banner banner(GameStage stage, Loading loading) {
        Language language = files.settings().get(Settings.LANGUAGE);
        return switch (stage) {
            case STARTING -> loading == null ? null : captions.of(loading, language);
            case RUNNING -> running(language);
            default -> null;
        };
    }

    /** Returns the texts of the last frame; {@code null} without an observer. */
    private static Banner observerBanner(Playthrough walk, Keys keys) {
        if (walk.observer() == null) {
            return null;
        }
        Language language = keys.language();
        ObserverSphere sphere = walk.frameState().observer();
        Phrase contact = sphere.touches() ? Phrase.BOUNDS_TOUCHED : Phrase.BOUNDS_APART;
        return new Banner(
                boundsPhrase(walk.observer().touchable()).in(language) + ": " + contact.in(language),
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

    private static Phrase boundsPhrase(Bound bounds) {
        return switch (bounds) {
            case SPHERE -> Phrase.BOUNDS_SPHERE;
            case BOX -> Phrase.BOUNDS_BOX;
            case ORIENTED_BOX -> Phrase.BOUNDS_ORIENTED_BOX;
            case TREE -> Phrase.BOUNDS_TREE;
            case TRIANGLES -> Phrase.BOUNDS_TRIANGLES;
        };
    }
}
