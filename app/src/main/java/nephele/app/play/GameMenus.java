package nephele.app.play;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import nephele.app.play.hud.HudContent;
import nephele.app.play.hud.Menu;
import nephele.app.play.hud.Menu.Choice;
import nephele.app.play.hud.Menu.Entry;
import nephele.app.settings.GameSetting;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Progress;
import nephele.app.settings.Settings;
import nephele.app.text.Phrase;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.engine.asset.Picture;
import nephele.engine.level.Language;
import nephele.engine.named.LevelName;
import nephele.engine.terminal.ProgramVersion;

/** Makes the pages of the menu from the player's settings and progress, in the player's language. */
final class GameMenus {
    private static final double TICKS_PER_SECOND = 120;

    private final PlayerFiles files;
    private final List<LevelName> campaign;
    private final Supplier<Input.Device> device;
    private final Map<LevelName, Optional<Picture>> pictures = new HashMap<>();

    /** @param device the one whose keys the pages name */
    GameMenus(PlayerFiles files, List<LevelName> campaign, Supplier<Input.Device> device) {
        this.files = files;
        this.device = device;
        this.campaign = campaign;
    }

    /** Returns the first level of the campaign that is not finished, else the first; empty without a campaign. */
    Optional<LevelName> nextToPlay() {
        return campaign.stream()
                .filter(level -> !files.progress().isFinished(level.fileName()))
                .findFirst()
                .or(() -> campaign.stream().findFirst());
    }

    Menu title() {
        List<Entry> entries = new ArrayList<>();
        boolean hasBegun = campaign.stream().anyMatch(level -> files.progress().isFinished(level.fileName()));
        nextToPlay()
                .ifPresent(level -> entries.add(new Entry(
                        text(hasBegun ? Phrase.CONTINUE : Phrase.BEGIN),
                        hasBegun ? level.title() : "",
                        new Choice.Play(level))));
        entries.add(new Entry(text(Phrase.LEVELS), new Choice.Open(Menu.Page.LEVELS)));
        entries.add(new Entry(text(Phrase.SETTINGS), new Choice.Open(Menu.Page.SETTINGS)));
        entries.add(new Entry(text(Phrase.QUIT), new Choice.Quit()));
        return menu("title", GameLoop.TITLE, List.of(ProgramVersion.text()), entries, null);
    }

    /**
     * Returns the page of a game that pauses.
     *
     * @param goal of the level that is paused; {@code null} if it says none
     */
    Menu pause(LevelName level, String goal) {
        List<String> lines = new ArrayList<>(List.of(level.title()));
        lines.addAll(goal == null ? List.of() : Menu.broken(goal));
        return menu(
                "pause",
                text(Phrase.PAUSED),
                lines,
                List.of(
                        new Entry(text(Phrase.CONTINUE), new Choice.Resume()),
                        new Entry(text(Phrase.RESTART), new Choice.Open(Menu.Page.RESTART_QUESTION)),
                        new Entry(text(Phrase.LEVELS), new Choice.Open(Menu.Page.LEVELS)),
                        new Entry(text(Phrase.SETTINGS), new Choice.Open(Menu.Page.SETTINGS)),
                        new Entry(text(Phrase.TO_TITLE), new Choice.ToTitle()),
                        new Entry(text(Phrase.QUIT), new Choice.Quit())),
                new Choice.Resume());
    }

    /**
     * Returns the page after a level's end.
     *
     * @param before progress before this run
     */
    Menu ended(PlayRequest request, FinishedRun run, Progress before, Optional<LevelName> next) {
        LevelName level = request.level();
        List<String> lines = new ArrayList<>();
        long best = before.bestTicks(level.fileName());
        boolean isBest = request.isRanked() && (best == 0 || run.ticks() < best);
        lines.add(text(Phrase.TIME) + "  " + time(run.ticks())
                + (isBest && best > 0 ? "  – " + text(Phrase.NEW_BEST) : ""));
        if (best > 0) {
            lines.add(text(Phrase.BEST) + "  " + time(isBest ? run.ticks() : best));
        }
        lines.add(text(Phrase.PORTALS) + "  " + run.portals());
        if (run.hints() > 0) {
            lines.add(text(Phrase.HINTS) + "  " + run.hints());
        }
        if (!request.isRanked()) {
            lines.add(text(Phrase.UNRANKED));
        }
        List<Entry> entries = new ArrayList<>();
        if (next.isPresent()) {
            entries.add(new Entry(text(Phrase.NEXT_LEVEL), next.get().title(), new Choice.Play(next.get())));
        } else {
            lines.add(text(Phrase.ALL_DONE));
        }
        entries.add(new Entry(text(Phrase.AGAIN), new Choice.Restart()));
        entries.add(new Entry(text(Phrase.LEVELS), new Choice.Open(Menu.Page.LEVELS)));
        entries.add(new Entry(text(Phrase.TO_TITLE), new Choice.ToTitle()));
        entries.add(new Entry(text(Phrase.QUIT), new Choice.Quit()));
        return menu("ended", level.title() + " – " + text(Phrase.LEVEL_DONE), lines, entries, new Choice.ToTitle());
    }

    Menu page(Menu.Page page) {
        return switch (page) {
            case LEVELS -> levels();
            case SETTINGS -> settings();
            case KEYS -> keys(null);
            case RESTART_QUESTION ->
                menu(
                        "restart-question",
                        text(Phrase.RESTART_QUESTION),
                        List.of(text(Phrase.RESTART_LOSS)),
                        List.of(
                                new Entry(text(Phrase.BACK), new Choice.Back()),
                                new Entry(text(Phrase.RESTART), new Choice.Restart())),
                        new Choice.Back());
        };
    }

    private Menu levels() {
        List<Entry> entries = new ArrayList<>();
        for (LevelName level : campaign) {
            long best = files.progress().bestTicks(level.fileName());
            entries.add(new Entry(
                    level.title(),
                    best > 0 ? "✓ " + time(best) : text(Phrase.NOT_YET),
                    new Choice.Play(level),
                    pictures.computeIfAbsent(level, LevelName::picture).orElse(null)));
        }
        entries.add(new Entry(text(Phrase.BACK), new Choice.Back()));
        return menu("levels", text(Phrase.LEVELS), List.of(), entries, new Choice.Back());
    }

    private Menu settings() {
        List<Entry> entries = new ArrayList<>();
        for (GameSetting<?> setting : Settings.PAGE) {
            entries.add(new Entry(
                    text(Phrase.ofSetting(setting.key())), "‹ " + value(setting) + " ›", new Choice.Step(setting, 1)));
        }
        entries.add(new Entry(text(Phrase.KEYS), new Choice.Open(Menu.Page.KEYS)));
        entries.add(new Entry(text(Phrase.BACK), new Choice.Back()));
        return menu("settings", text(Phrase.SETTINGS), List.of(), entries, new Choice.Back());
    }

    /** @param waiting the control whose key is awaited; null for none */
    Menu keys(Control waiting) {
        var keys = new HudContent.Keys(Settings.bindings(files.settings()), Input.Device.KEYBOARD, language());
        List<Entry> entries = new ArrayList<>();
        for (Control control : Settings.KEYS.keySet()) {
            String value = control == waiting ? text(Phrase.PRESS_KEY) : keyText(keys, control);
            entries.add(new Entry(keys.meaning(control), value, new Choice.Bind(control)));
        }
        entries.add(new Entry(text(Phrase.BACK), new Choice.Back()));
        return menu("keys", text(Phrase.KEYS), List.of(), entries, new Choice.Back());
    }

    /** Returns a control's keys, and the control that has one of them too. */
    private String keyText(HudContent.Keys keys, Control control) {
        Control other = keys.bindings().conflict(control);
        String names = keys.names(control).isEmpty() ? text(Phrase.NO_KEY) : keys.names(control);
        return other == null ? names : names + " – " + Phrase.ALSO.in(language(), keys.meaning(other));
    }

    private <T> String value(GameSetting<T> setting) {
        T value = files.settings().get(setting);
        if (value instanceof Language language) {
            return language.title();
        }
        if (value instanceof Enum<?> word) {
            return text(Phrase.ofWord(word));
        }
        if (value instanceof String text) {
            return text.equals(Settings.AUTO_RESOLUTION)
                    ? text(Phrase.ofWord(Settings.QualityPreset.AUTO))
                    : text.replace('x', '×');
        }
        double number = (Double) value;
        if (setting.equals(Settings.FRAME_CAP) && number == 0) {
            return text(Phrase.WORD_OFF);
        }
        if (setting.equals(Settings.AUTO_FRAME_RATE) && number == 0) {
            return text(Phrase.ofWord(Settings.QualityPreset.AUTO));
        }
        String unit = setting.equals(Settings.FIELD_OF_VIEW) ? "°" : "";
        return (number == Math.rint(number) && !setting.equals(Settings.MOUSE_SPEED)
                        ? Long.toString((long) number)
                        : String.format(Locale.ROOT, "%.1f", number))
                + unit;
    }

    private Menu menu(String name, String title, List<String> lines, List<Entry> entries, Choice escape) {
        boolean isPad = device.get() == Input.Device.GAMEPAD;
        String foot = text(isPad ? Phrase.PAD_MENU_KEYS : Phrase.MENU_KEYS);
        String back = isPad ? "B" : Phrase.ofKey("Escape", language());
        if (escape instanceof Choice.Resume) {
            foot += "     " + back + "  " + text(Phrase.FOOT_CONTINUE);
        } else if (escape instanceof Choice.Back) {
            foot += "     " + back + "  " + text(Phrase.FOOT_BACK);
        }
        return new Menu(name, title, lines, entries, 0, escape, foot);
    }

    private String text(Phrase phrase) {
        return phrase.in(language());
    }

    Language language() {
        return files.settings().get(Settings.LANGUAGE);
    }

    PlayerFiles files() {
        return files;
    }

    /** Returns minutes, seconds and hundredths. */
    static String time(long ticks) {
        long hundredths = Math.round(ticks / TICKS_PER_SECOND * 100);
        return String.format(Locale.ROOT, "%d:%02d.%02d", hundredths / 6000, hundredths / 100 % 60, hundredths % 100);
    }
}
