package nephele.editor.text;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The names that a designer reads for sections and kinds of entities; one without a name here is called as in files. */
public final class EntityWords {
    /** A heading of the palette. */
    public enum Group {
        PLAY("Game", "Jogo", "Jogo"),
        LIGHT("Light", "Luz", "Luz"),
        SKY("Sky and air", "Céu e ar", "Céu e ar"),
        SCENE("Scene", "Cena", "Cena"),
        SOLIDS("Exact solids", "Sólidos exatos", "Sólidos exatos"),
        OTHER("Other", "Outros", "Outros");

        private final Words words;

        Group(String english, String brazilian, String european) {
            words = Words.of(english, brazilian, european);
        }

        public Words words() {
            return words;
        }
    }

    /** @param words {@code null} for those of the kind alone */
    private record Named(Group group, Words words) {}

    private static final Map<String, Named> KINDS = new LinkedHashMap<>();
    private static final Map<String, Words> SECTIONS = new LinkedHashMap<>();

    static {
        kind("player", Group.PLAY, Words.of("Start", "Início", "Início"));
        kind("exits", Group.PLAY);
        kind("bodies.box", Group.PLAY, Words.of("Cube", "Cubo", "Cubo"));
        kind("bodies.sphere", Group.PLAY, Words.of("Ball", "Bola", "Bola"));
        kind("bodies", Group.PLAY);
        kind("portals", Group.PLAY);
        kind("portalGun", Group.PLAY);
        kind("observer", Group.PLAY);
        kind("par", Group.PLAY);
        kind("landmark", Group.PLAY, Words.of("Landmark", "Marco", "Marco"));
        kind("hints", Group.PLAY);
        kind("lights", Group.LIGHT);
        kind("environment.sun", Group.LIGHT);
        kind("emitters", Group.SCENE);
        kind("billboards", Group.SCENE);
        kind("environment.clouds", Group.SKY);
        kind("environment.sky", Group.SKY);
        kind("environment.fog", Group.SKY);
        kind("environment.lightning", Group.SKY);
        kind("terrains", Group.SCENE);
        kind("models", Group.SCENE);
        kind("cameras", Group.SCENE);
        kind("materials", Group.SCENE);
        kind("solids", Group.SOLIDS);
        SECTIONS.put("solids", Words.of("Brushes", "Blocos", "Blocos"));
        SECTIONS.put("player", Words.of("Start", "Início", "Início"));
    }

    private EntityWords() {}

    private static void kind(String key, Group group) {
        kind(key, group, null);
    }

    private static void kind(String key, Group group, Words words) {
        KINDS.put(key, new Named(group, words));
    }

    private static Named find(String section, String kind) {
        Named named = KINDS.get(section + "." + kind);
        return named == null ? KINDS.get(section) : named;
    }

    /** Returns the name of a kind of entity of a section, such as "Cube" for {@code bodies}, {@code box}. */
    public static Words ofKind(String section, String kind) {
        Named named = find(section, kind);
        return named == null || named.words() == null ? KindWords.of(kind) : named.words();
    }

    /** Returns the heading under which the palette offers a kind. */
    public static Group group(String section, String kind) {
        Named named = find(section, kind);
        return named == null ? Group.OTHER : named.group();
    }

    /** Returns the place of a kind in the order of the palette. */
    public static int rank(String section, String kind) {
        List<String> order = List.copyOf(KINDS.keySet());
        String key = section + "." + kind;
        int rank = order.indexOf(KINDS.containsKey(key) ? key : section);
        return rank < 0 ? order.size() : rank;
    }

    /** Returns the name of a section, such as "Lights" for {@code lights}. */
    public static Words ofSection(String path) {
        String last = path.substring(path.lastIndexOf('.') + 1);
        return Optional.ofNullable(SECTIONS.get(path))
                .or(() -> FieldWords.known(last))
                .orElseGet(() -> Words.same(FieldWords.sentence(last)));
    }
}
