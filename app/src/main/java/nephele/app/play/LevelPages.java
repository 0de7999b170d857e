package nephele.app.play;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import nephele.app.play.hud.Menu;
import nephele.app.play.hud.Menu.Card;
import nephele.app.play.hud.Menu.Choice;
import nephele.app.play.hud.Menu.Entry;
import nephele.app.play.hud.Menu.Fact;
import nephele.app.settings.Phrase;
import nephele.app.settings.Progress;
import nephele.engine.level.Language;
import nephele.engine.level.Level;
import nephele.host.compare.TechniquePair;
import nephele.host.named.LevelCatalogue;
import nephele.host.named.LevelName;
import nephele.host.named.LevelSummary;
import nephele.host.named.LevelTitles;
import nephele.host.named.SampleCatalogue.Group;
import nephele.host.named.SampleCatalogue.Sample;

/** The pages that list levels: the campaign, the samples in groups, and the player's own folder. */
final class LevelPages {
    private static final int TICKS_PER_SECOND = 120;
    private static final int MOST_PROBLEMS = 3;
    private static final int LONGEST_TITLE = 28;
    private static final int LONGEST_TEXT = 320;

    private final PageWriter writer;
    private final List<LevelName> campaign;
    private final LevelTitles titles;
    private LevelReader campaignReader;
    private LevelReader ownReader;
    private int shownCampaign;
    private int shownOwn;

    LevelPages(PageWriter writer, List<LevelName> campaign, LevelTitles titles) {
        this.writer = writer;
        this.titles = titles;
        this.campaign = campaign;
    }

    /** Returns the list in which a level stands. */
    Menu.Page listOf(LevelName level) {
        if (titles.sample(level.typed()).isPresent()) {
            return Menu.Page.SAMPLES;
        }
        Path folder = writer.files().levels();
        return folder != null && LevelCatalogue.isIn(folder, level) ? Menu.Page.YOUR_LEVELS : Menu.Page.LEVELS;
    }

    /** Returns the title of a level. */
    String title(LevelName level) {
        return titles.of(level, writer.language());
    }

    /** Returns an open page with what has been read since it was written; empty if that is nothing. */
    Optional<Menu> refreshed(Menu page) {
        boolean isCampaign = page.name().equals("levels") && campaignReader.done() != shownCampaign;
        boolean isOwn = page.name().equals("your-levels") && ownReader.done() != shownOwn;
        return isCampaign ? Optional.of(campaignPage()) : isOwn ? Optional.of(ownPage()) : Optional.empty();
    }

    /** Returns true if all levels of the opened lists have been read. */
    boolean isRead() {
        return (campaignReader == null || campaignReader.isDone()) && (ownReader == null || ownReader.isDone());
    }

    Menu campaign() {
        if (campaignReader == null) {
            campaignReader = LevelReader.begin(campaign, LevelSummary::unchecked);
        }
        return campaignPage();
    }

    private Menu campaignPage() {
        shownCampaign = campaignReader.done();
        List<Entry> entries = new ArrayList<>();
        for (LevelName level : campaign) {
            Optional<LevelSummary> read = campaignReader.of(level);
            entries.add(new Entry(title(level), best(level), new Choice.Play(level)).with(card(level, read)));
        }
        entries.add(writer.back());
        return writer.page("levels", writer.text(Phrase.LEVELS), List.of(), entries, Choice.Plain.BACK);
    }

    private String best(LevelName level) {
        long best = writer.files().progress().bestTicks(level.key());
        return best > 0 ? "✓ " + PageWriter.time(best) : writer.text(Phrase.NOT_YET);
    }

    /** Returns picture, records beside the par, and aim of a level; the facts alone until it was read. */
    private Card card(LevelName level, Optional<LevelSummary> read) {
        Level.Par par = read.map(LevelSummary::par).orElse(null);
        String about = read.map(this::about).orElse("");
        return new Card(read.map(LevelSummary::picture).orElse(null), facts(level, par), about);
    }

    private String about(LevelSummary summary) {
        String aim = summary.aim().getOrDefault(writer.language(), summary.aim().get(Language.EN));
        return shortened(aim == null ? summary.description() : aim, LONGEST_TEXT);
    }

    private List<Fact> facts(LevelName level, Level.Par par) {
        Progress progress = writer.files().progress();
        boolean isFinished = progress.isFinished(level.key());
        String best = isFinished ? PageWriter.time(progress.bestTicks(level.key())) : "–";
        String portals = isFinished ? Long.toString(progress.portals(level.key())) : "–";
        return List.of(
                new Fact(writer.text(Phrase.BEST_TIME), best, par == null ? "" : par(parTime(par.seconds()))),
                new Fact(
                        writer.text(Phrase.PORTALS_USED),
                        portals,
                        par == null ? "" : par(Integer.toString(par.portals()))));
    }

    private String par(String value) {
        return Phrase.PAR.in(writer.language(), value);
    }

    /** Returns the time of a par, without hundredths where it has none. */
    private static String parTime(double seconds) {
        return PageWriter.time(Math.round(seconds * TICKS_PER_SECOND)).replaceFirst("\\.00$", "");
    }

    Menu sampleGroups() {
        List<Entry> entries = new ArrayList<>();
        for (int i = 0; i < titles.samples().groups().size(); i++) {
            Group group = titles.samples().groups().get(i);
            entries.add(new Entry(
                            group.title().get(writer.language()),
                            Integer.toString(group.samples().size()),
                            new Choice.OpenSamples(i))
                    .helped(group.about().get(writer.language())));
        }
        entries.add(writer.back());
        return writer.page("samples", writer.text(Phrase.SAMPLES), List.of(), entries, Choice.Plain.BACK);
    }

    /** @param number of the group in the catalogue */
    Menu samples(int number) {
        Group group = titles.samples().groups().get(number);
        List<Entry> entries = new ArrayList<>();
        for (Sample sample : group.samples()) {
            String title = sample.title().get(writer.language());
            entries.add(new Entry(title, choice(sample)).helped(sample.about().get(writer.language())));
        }
        entries.add(writer.back());
        String title = group.title().get(writer.language());
        return writer.page("samples-" + (number + 1), title, List.of(), entries, Choice.Plain.BACK);
    }

    private static Choice choice(Sample sample) {
        if (sample.isScene()) {
            return new Choice.Show(sample.file());
        }
        LevelName level = new LevelName(sample.file());
        return sample.compare() == null
                ? new Choice.Play(level)
                : new Choice.Compare(level, TechniquePair.parse(sample.compare()));
    }

    /** Returns the player's own levels; the folder is looked through anew. */
    Menu own() {
        Path folder = writer.files().levels();
        if (ownReader != null) {
            ownReader.end();
        }
        ownReader = LevelReader.begin(folder == null ? List.of() : LevelCatalogue.in(folder), LevelSummary::checked);
        return ownPage();
    }

    private Menu ownPage() {
        Path folder = writer.files().levels();
        shownOwn = ownReader.done();
        List<Entry> entries = new ArrayList<>();
        int broken = 0;
        for (LevelName level : ownReader.levels()) {
            Optional<LevelSummary> read = ownReader.of(level);
            boolean isBroken = read.isPresent() && !read.get().isGood();
            broken += isBroken ? 1 : 0;
            entries.add(isBroken ? broken(level, read.get()) : own(level, read));
        }
        if (folder != null) {
            entries.add(new Entry(writer.text(Phrase.SHOW_FOLDER), new Choice.ShowFolder(folder))
                    .with(new Card(null, List.of(), Phrase.YOUR_LEVELS_HOW.in(writer.language(), folder))));
        }
        entries.add(writer.back());
        String line = folder == null ? writer.text(Phrase.NO_LEVELS_FOLDER) : count(broken);
        return writer.page("your-levels", writer.text(Phrase.YOUR_LEVELS), List.of(line), entries, Choice.Plain.BACK);
    }

    private String count(int broken) {
        int all = ownReader.levels().size();
        if (all == 0) {
            return writer.text(Phrase.NO_LEVEL_YET);
        }
        if (shownOwn < all) {
            return Phrase.LEVELS_READ.in(writer.language(), shownOwn, all);
        }
        return broken == 0
                ? Phrase.LEVELS_GOOD.in(writer.language(), all)
                : Phrase.LEVELS_BROKEN.in(writer.language(), all, broken);
    }

    private Entry own(LevelName level, Optional<LevelSummary> read) {
        String name = read.map(LevelSummary::name).orElse("");
        String title = shortened(name.isEmpty() ? level.title() : name, LONGEST_TITLE);
        String value = read.isPresent() ? best(level) : "…";
        List<Fact> facts = new ArrayList<>(card(level, read).facts());
        facts.add(
                0,
                new Fact(
                        writer.text(Phrase.FILE),
                        LevelCatalogue.nameIn(writer.files().levels(), level)));
        Card card = new Card(
                read.map(LevelSummary::picture).orElse(null),
                facts,
                read.map(this::about).orElse(""));
        return new Entry(title, value, new Choice.Play(level)).with(card);
    }

    private static String shortened(String text, int most) {
        return text.codePointCount(0, text.length()) <= most
                ? text
                : text.substring(0, text.offsetByCodePoints(0, most - 1)).strip() + "…";
    }

    /** Returns an entry that tells what is wrong with a level, and starts nothing. */
    private Entry broken(LevelName level, LevelSummary summary) {
        List<String> problems = summary.problems();
        String shown = String.join("\n", problems.subList(0, Math.min(MOST_PROBLEMS, problems.size())));
        String more = problems.size() > MOST_PROBLEMS
                ? "\n" + Phrase.MORE_PROBLEMS.in(writer.language(), problems.size() - MOST_PROBLEMS)
                : "";
        Fact file = new Fact(
                writer.text(Phrase.FILE), LevelCatalogue.nameIn(writer.files().levels(), level));
        return new Entry(shortened(level.title(), LONGEST_TITLE), writer.text(Phrase.BROKEN), null)
                .with(new Card(null, List.of(file), shown + more));
    }
}
