package nephele.app.play;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import nephele.app.play.hud.Menu;
import nephele.app.play.hud.Menu.Choice;
import nephele.app.play.hud.Menu.Entry;
import nephele.app.settings.GameSetting;
import nephele.app.settings.Phrase;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Progress;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.host.named.LevelName;
import nephele.host.named.LevelTitles;
import nephele.host.terminal.ProgramVersion;

/** Makes the pages of the menu from the player's settings and progress, in the player's language. */
final class GameMenus {
    private final PlayerFiles files;
    private final List<LevelName> campaign;
    private final PageWriter writer;
    private final SettingsPages settings;
    private final LevelPages levels;

    /** @param device the one whose keys the pages name */
    GameMenus(PlayerFiles files, List<LevelName> campaign, LevelTitles titles, Supplier<Input.Device> device) {
        this.files = files;
        this.campaign = campaign;
        writer = new PageWriter(files, device);
        settings = new SettingsPages(writer);
        levels = new LevelPages(writer, campaign, titles);
    }

    /** Returns the first level of the campaign that is not finished, else the first; empty without a campaign. */
    Optional<LevelName> nextToPlay() {
        return campaign.stream()
                .filter(level -> !files.progress().isFinished(level.key()))
                .findFirst()
                .or(() -> campaign.stream().findFirst());
    }

    Menu title() {
        List<Entry> entries = new ArrayList<>();
        boolean hasBegun = campaign.stream().anyMatch(level -> files.progress().isFinished(level.key()));
        nextToPlay()
                .ifPresent(level -> entries.add(new Entry(
                        text(hasBegun ? Phrase.CONTINUE : Phrase.BEGIN),
                        hasBegun ? levels.title(level) : "",
                        new Choice.Play(level))));
        entries.add(new Entry(text(Phrase.LEVELS), new Choice.Open(Menu.Page.LEVELS)));
        entries.add(new Entry(text(Phrase.SAMPLES), new Choice.Open(Menu.Page.SAMPLES)));
        entries.add(new Entry(text(Phrase.YOUR_LEVELS), new Choice.Open(Menu.Page.YOUR_LEVELS)));
        entries.add(new Entry(text(Phrase.SETTINGS), new Choice.Open(Menu.Page.SETTINGS)));
        entries.add(new Entry(text(Phrase.QUIT), Choice.Plain.QUIT));
        return writer.page("title", GameLoop.TITLE, List.of(ProgramVersion.text()), entries, null);
    }

    /**
     * Returns the page of a game that pauses.
     *
     * @param goal of the level that is paused; {@code null} if it says none
     */
    Menu pause(LevelName level, String goal) {
        List<String> lines = new ArrayList<>(List.of(levels.title(level)));
        lines.addAll(goal == null ? List.of() : Menu.broken(goal));
        return writer.page(
                "pause",
                text(Phrase.PAUSED),
                lines,
                List.of(
                        new Entry(text(Phrase.CONTINUE), Choice.Plain.RESUME),
                        new Entry(text(Phrase.RESTART), new Choice.Open(Menu.Page.RESTART_QUESTION)),
                        listOf(level),
                        new Entry(text(Phrase.SETTINGS), new Choice.Open(Menu.Page.SETTINGS)),
                        new Entry(text(Phrase.TO_TITLE), Choice.Plain.TO_TITLE),
                        new Entry(text(Phrase.QUIT), Choice.Plain.QUIT)),
                Choice.Plain.RESUME);
    }

    /**
     * Returns the page after a level's end.
     *
     * @param before progress before this run
     */
    Menu ended(PlayRequest request, FinishedRun run, Progress before, Optional<LevelName> next) {
        LevelName level = request.level();
        List<String> lines = new ArrayList<>();
        long best = before.bestTicks(level.key());
        boolean isBest = request.isRanked() && (best == 0 || run.ticks() < best);
        lines.add(text(Phrase.TIME) + "  " + PageWriter.time(run.ticks())
                + (isBest && best > 0 ? "  – " + text(Phrase.NEW_BEST) : ""));
        if (best > 0) {
            lines.add(text(Phrase.BEST) + "  " + PageWriter.time(isBest ? run.ticks() : best));
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
            entries.add(new Entry(text(Phrase.NEXT_LEVEL), levels.title(next.get()), new Choice.Play(next.get())));
        } else if (campaign.stream().anyMatch(each -> each.key().equals(level.key()))) {
            lines.add(text(Phrase.ALL_DONE));
        }
        entries.add(new Entry(text(Phrase.AGAIN), Choice.Plain.RESTART));
        entries.add(listOf(level));
        entries.add(new Entry(text(Phrase.TO_TITLE), Choice.Plain.TO_TITLE));
        entries.add(new Entry(text(Phrase.QUIT), Choice.Plain.QUIT));
        return writer.page(
                "ended", levels.title(level) + " – " + text(Phrase.LEVEL_DONE), lines, entries, Choice.Plain.TO_TITLE);
    }

    /** Returns the entry that opens the list in which a level stands. */
    private Entry listOf(LevelName level) {
        Menu.Page list = levels.listOf(level);
        Phrase name =
                switch (list) {
                    case SAMPLES -> Phrase.SAMPLES;
                    case YOUR_LEVELS -> Phrase.YOUR_LEVELS;
                    default -> Phrase.LEVELS;
                };
        return new Entry(text(name), new Choice.Open(list));
    }

    Menu page(Menu.Page page) {
        return switch (page) {
            case LEVELS -> levels.campaign();
            case SAMPLES -> levels.sampleGroups();
            case YOUR_LEVELS -> levels.own();
            case SETTINGS -> settings.groups();
            case KEYS -> settings.keys(null);
            case RESTART_QUESTION ->
                writer.page(
                        "restart-question",
                        text(Phrase.RESTART_QUESTION),
                        List.of(text(Phrase.RESTART_LOSS)),
                        List.of(
                                new Entry(text(Phrase.BACK), Choice.Plain.BACK),
                                new Entry(text(Phrase.RESTART), Choice.Plain.RESTART)),
                        Choice.Plain.BACK);
        };
    }

    /** @param waiting the control whose key is awaited; null for none */
    Menu keys(Control waiting) {
        return settings.keys(waiting);
    }

    /** Returns the page on which a setting stands. */
    Menu pageOf(GameSetting<?> setting) {
        return settings.pageOf(setting);
    }

    Menu settings(GameSetting.Group group) {
        return settings.of(group);
    }

    /** Returns the samples of a group, by its place in the catalogue. */
    Menu samples(int group) {
        return levels.samples(group);
    }

    /** Returns true if all levels of the opened lists have been read. */
    boolean isRead() {
        return levels.isRead();
    }

    /** Returns an open page with what has been read since it was written; empty if that is nothing. */
    Optional<Menu> refreshed(Menu page) {
        return levels.refreshed(page);
    }

    private String text(Phrase phrase) {
        return writer.text(phrase);
    }

    PlayerFiles files() {
        return files;
    }
}
