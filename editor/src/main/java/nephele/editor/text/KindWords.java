package nephele.editor.text;

import static java.util.Map.entry;

import java.util.Map;
import java.util.Optional;

/** The names of kinds of entities in words. A kind that has none here is named as files name it. */
public final class KindWords {
    private static final Map<String, Words> ALL = Map.ofEntries(
            word("atmosphere", "Atmosphere", "Atmosfera", "Atmosfera"),
            word("billboards", "Billboards", "Placas", "Placas"),
            word("box", "Box", "Caixa", "Caixa"),
            word("camera", "Camera", "Câmera", "Câmara"),
            word("capsule", "Capsule", "Cápsula", "Cápsula"),
            word("cloud", "Cloud", "Nuvem", "Nuvem"),
            word("constant", "Even", "Uniforme", "Uniforme"),
            word("emitter", "Particles", "Partículas", "Partículas"),
            word("exit", "Exit", "Saída", "Saída"),
            word("fog", "Fog", "Neblina", "Nevoeiro"),
            word("hint", "Hint", "Dica", "Pista"),
            word("lightning", "Lightning", "Relâmpagos", "Relâmpagos"),
            word("gradient", "Gradient", "Gradiente", "Gradiente"),
            word("material", "Material", "Material", "Material"),
            word("modelplacement", "Model", "Modelo", "Modelo"),
            word("observer", "Observer's sphere", "Esfera do observador", "Esfera do observador"),
            word("par", "Par of the level", "Meta da fase", "Meta do nível"),
            word("place", "Place", "Lugar", "Lugar"),
            word("planes", "Solid of planes", "Sólido de planos", "Sólido de planos"),
            word("playerstart", "Player start", "Início do jogador", "Início do jogador"),
            word("point", "Point light", "Luz pontual", "Luz pontual"),
            word("portalgun", "Portal gun", "Arma de portais", "Arma de portais"),
            word("portalspec", "Portal", "Portal", "Portal"),
            word("prism", "Prism", "Prisma", "Prisma"),
            word("skybox", "Sky box", "Caixa de céu", "Caixa de céu"),
            word("sphere", "Sphere", "Esfera", "Esfera"),
            word("spot", "Spot light", "Refletor", "Projetor"),
            word("sun", "Sun", "Sol", "Sol"),
            word("terrain", "Terrain", "Terreno", "Terreno"),
            word("wedge", "Wedge", "Cunha", "Cunha"));

    private KindWords() {}

    private static Map.Entry<String, Words> word(String name, String english, String brazilian, String european) {
        return entry(name, Words.of(english, brazilian, european));
    }

    /** Returns the words of a kind. */
    public static Words of(String kind) {
        return known(kind).orElseGet(() -> Words.same(FieldWords.sentence(kind)));
    }

    /** Returns the words of a kind; empty for an unknown one. */
    public static Optional<Words> known(String kind) {
        return Optional.ofNullable(ALL.get(kind));
    }
}
