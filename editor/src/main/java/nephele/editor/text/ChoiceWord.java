package nephele.editor.text;

import java.util.Map;
import nephele.engine.level.Exposure;
import nephele.engine.level.json.WordFormats;

/** The word for a constant or a key of a table. */
public final class ChoiceWord {
    private static final Map<String, Words> ALL = Map.ofEntries(
            word("arch", "Arch", "Arco", "Arco"),
            word("auto", "Automatic", "Automático", "Automático"),
            word("billboard", "Billboards", "Painéis voltados à câmera", "Painéis voltados à câmara"),
            word("broken", "Broken clouds", "Muitas nuvens", "Muitas nuvens"),
            word("cirrus", "Cirrus", "Cirros", "Cirros"),
            word("clear", "Clear", "Céu limpo", "Céu limpo"),
            word("clip", "Clipped", "Cortada", "Cortada"),
            word("cross", "Cross", "Cruz", "Cruz"),
            word("cumulonimbus", "Cumulonimbus", "Cumulonimbo", "Cumulonimbo"),
            word("cumulus", "Cumulus", "Cúmulo", "Cúmulo"),
            word("ellipse", "Ellipse", "Elipse", "Elipse"),
            word("explosion", "Explosion", "Explosão", "Explosão"),
            word("face", "Along the face", "Ao longo da face", "Ao longo da face"),
            word("faces", "Six pictures", "Seis imagens", "Seis imagens"),
            word("few", "Few clouds", "Poucas nuvens", "Poucas nuvens"),
            word("filmic", "Filmic", "Fílmica", "Fílmica"),
            word("fire", "Fire", "Fogo", "Fogo"),
            word("opengl", "OpenGL cube", "Cubo do OpenGL", "Cubo do OpenGL"),
            word("overcast", "Overcast", "Encoberto", "Encoberto"),
            word("particles", "Particles", "Partículas", "Partículas"),
            word("procedural", "Procedural noise", "Ruído procedural", "Ruído procedural"),
            word("quake2", "Quake II", "Quake II", "Quake II"),
            word("quads", "Squares of the report", "Quadrados do relatório", "Quadrados do relatório"),
            word("rain", "Rain", "Chuva", "Chuva"),
            word("rectangle", "Rectangle", "Retângulo", "Retângulo"),
            word("scattered", "Scattered clouds", "Nuvens esparsas", "Nuvens dispersas"),
            word("skybox", "Sky box", "Caixa de céu", "Caixa de céu"),
            word("skyplane", "Sky planes", "Planos de céu", "Planos de céu"),
            word("smoke", "Smoke", "Fumaça", "Fumo"),
            word("snow", "Snow", "Neve", "Neve"),
            word("sparks", "Sparks", "Faíscas", "Faíscas"),
            word("storm", "Storm", "Tempestade", "Tempestade"),
            word("stratus", "Stratus", "Estrato", "Estrato"),
            word("terragen", "Terragen", "Terragen", "Terragen"),
            word("volume", "Volume", "Volume", "Volume"),
            word("world", "Along the world's axes", "Ao longo dos eixos do mundo", "Ao longo dos eixos do mundo"));

    private ChoiceWord() {}

    private static Map.Entry<String, Words> word(String name, String english, String brazilian, String european) {
        return Map.entry(name, Words.of(english, brazilian, european));
    }

    /** Returns the word that files have. */
    public static String of(Object value) {
        return value instanceof Enum<?> ? WordFormats.Choice.word(value) : String.valueOf(value);
    }

    /** Returns the words that a designer reads: those of files for a key, a number, and a constant without a name here. */
    public static Words words(Object value) {
        Words inFiles = Words.same(of(value));
        return value instanceof Enum<?> || value instanceof Exposure ? ALL.getOrDefault(of(value), inFiles) : inFiles;
    }
}
