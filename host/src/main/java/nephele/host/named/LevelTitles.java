package nephele.host.named;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import nephele.engine.level.Language;

/** The titles of levels and samples in each language: from the campaign, the list of samples, else the file names. */
public final class LevelTitles {
    /** The titles that file names give. */
    public static final LevelTitles OF_FILES = new LevelTitles(Map.of(), () -> new SampleCatalogue(List.of()));

    private final Map<String, Map<Language, String>> campaign;
    private final Supplier<SampleCatalogue> samples;
    private final Map<String, SampleCatalogue.Sample> sampleOfFile = new HashMap<>();
    /** {@code null} until it is needed: the game begins without reading it. */
    private SampleCatalogue read;

    /**
     * @param campaign titles by the {@linkplain LevelName#key key} of a level and language
     * @param samples reads the list of samples
     */
    LevelTitles(Map<String, Map<Language, String>> campaign, Supplier<SampleCatalogue> samples) {
        this.campaign = campaign;
        this.samples = samples;
    }

    /** Returns the samples; they are read at the first call. */
    public SampleCatalogue samples() {
        if (read == null) {
            read = samples.get();
            read.groups().stream()
                    .flatMap(group -> group.samples().stream())
                    .forEach(sample -> sampleOfFile.putIfAbsent(sample.file(), sample));
        }
        return read;
    }

    /** Returns the sample that is in a file. */
    public Optional<SampleCatalogue.Sample> sample(String file) {
        samples();
        return Optional.ofNullable(sampleOfFile.get(file));
    }

    /** Returns the title of a level. */
    public String of(LevelName level, Language language) {
        Map<Language, String> titles = campaign.get(level.key());
        return titles != null ? in(titles, language, level.title()) : of(level.typed(), language, level.title());
    }

    /**
     * Returns the title of a level or scene that may be a sample.
     *
     * @param otherwise the title of one that is none
     */
    public String of(String file, Language language, String otherwise) {
        return sample(file)
                .map(sample -> in(sample.title(), language, otherwise))
                .orElse(otherwise);
    }

    /** Returns the title in a language, or in English. */
    private static String in(Map<Language, String> titles, Language language, String otherwise) {
        return titles.getOrDefault(language, titles.getOrDefault(Language.EN, otherwise));
    }
}
