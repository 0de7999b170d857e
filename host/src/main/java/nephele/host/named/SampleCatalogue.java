package nephele.host.named;

import java.util.List;
import java.util.Map;
import nephele.engine.level.Language;
import nephele.engine.level.TextKind;
import nephele.engine.level.Written;
import nephele.engine.level.json.RecordFile;

/**
 * The samples of the game in groups, in the words of its players: the content of {@code levels/samples.json}.
 *
 * @param groups in the order of the list
 */
public record SampleCatalogue(@Written(required = true, most = 100) List<Group> groups) {
    private static final RecordFile<SampleCatalogue> FILE = RecordFile.of("samples", 1, SampleCatalogue.class);

    /**
     * Samples of one kind.
     *
     * @param about a sentence
     */
    public record Group(
            @Written(required = true) Map<Language, String> title,
            @Written(required = true) Map<Language, String> about,
            @Written(required = true, most = 1000) List<Sample> samples) {}

    /**
     * A sample.
     *
     * @param file from the game's folder on: {@code levels/samples/fog.json}, or an XML scene such as {@code
     *     scenes/ship.xml}
     * @param compare two techniques of clouds that are compared in it, such as {@code particles,volume}; {@code null}
     *     for none
     * @param about a sentence
     */
    public record Sample(
            @Written(required = true, text = TextKind.ASSET) String file,
            @Written String compare,
            @Written(required = true) Map<Language, String> title,
            @Written(required = true) Map<Language, String> about) {
        public boolean isScene() {
            return file.endsWith(".xml");
        }
    }

    static SampleCatalogue read(String file, byte[] utf8) {
        return FILE.read(file, utf8);
    }
}
