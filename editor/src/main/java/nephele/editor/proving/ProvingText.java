package nephele.editor.proving;

import nephele.editor.text.Text;
import nephele.editor.text.Words;

/** A text of proofs in English, Brazilian and European Portuguese. */
public enum ProvingText implements Text {
    HEAT_PROGRESS(
            "Computing where portals fit: %s %%",
            "Calculando onde cabem portais: %s %%", "A calcular onde cabem portais: %s %%"),
    HEAT_DONE(
            "Portals: %s places fit, %s slide, %s refused",
            "Portais: %s lugares servem, %s deslizam, %s recusados",
            "Portais: %s lugares servem, %s deslizam, %s recusados"),
    TRACED(
            "Path traced: %s samples per pixel",
            "Raios traçados: %s amostras por pixel", "Raios traçados: %s amostras por píxel"),
    TRACING("Path tracing …", "Traçando raios …", "A traçar raios …"),
    NO_PROBLEMS("No problems", "Nenhum problema", "Nenhum problema"),
    PROBLEMS(
            "Problems: %s errors, %s warnings, %s hints",
            "Problemas: %s erros, %s avisos, %s dicas", "Problemas: %s erros, %s avisos, %s sugestões"),
    UNSAVED("save the level first: %s", "salve a fase antes: %s", "guarda primeiro o nível: %s"),
    NEEDS_SOLUTION("its solution is kept beside it", "a solução fica ao lado dela", "a solução fica ao lado dele"),
    NEEDS_FILE("the report reads its file", "o relatório lê o arquivo dela", "o relatório lê o ficheiro dele"),
    TRADE_STARTED(
            "Measuring speed against accuracy; the same command again stops it",
            "Medindo velocidade contra precisão; o mesmo comando de novo interrompe",
            "A medir velocidade contra precisão; o mesmo comando outra vez interrompe"),
    TRADE_PROGRESS("Speed against accuracy: %s", "Velocidade contra precisão: %s", "Velocidade contra precisão: %s"),
    TRADE_STOPPED(
            "The report was stopped; it goes on where it was next time",
            "O relatório foi interrompido; da próxima vez continua de onde estava",
            "O relatório foi interrompido; da próxima vez continua de onde estava"),
    TRADE_DONE("The report is %s", "O relatório é %s", "O relatório é %s"),
    TRADE_FAILED("No report: %s", "Sem relatório: %s", "Sem relatório: %s"),
    EXPLANATION("Explanation of a Pixel", "Explicação de um pixel", "Explicação de um píxel"),
    PIXEL(
            "Pixel %s, %s of %s × %s, seen from %s",
            "Pixel %s, %s de %s × %s, visto de %s", "Píxel %s, %s de %s × %s, visto de %s"),
    SEES("Sees: %s, at %s", "Mostra: %s, em %s", "Mostra: %s, em %s"),
    SEES_NOTHING("Sees: no surface, the sky", "Mostra: nenhuma superfície, o céu", "Mostra: nenhuma superfície, o céu"),
    ON_THE_WAY(
            "The sight passes through portals or mirrors",
            "A visão passa por portais ou espelhos",
            "A vista passa por portais ou espelhos"),
    FACE(
            "Face: %s, material %s, %s, %s m away",
            "Face: %s, material %s, %s, a %s m", "Face: %s, material %s, %s, a %s m"),
    TAKES_PORTALS("takes portals", "aceita portais", "aceita portais"),
    TAKES_NONE("takes no portals", "não aceita portais", "não aceita portais"),
    LIGHT(
            "Traced radiance: %s (mean of %s samples), shown as %s",
            "Radiância traçada: %s (média de %s amostras), exibida como %s",
            "Radiância traçada: %s (média de %s amostras), mostrada como %s"),
    PASSES("Passes of the frame:", "Passos do quadro:", "Passos da imagem:"),
    CLOSE("Close", "Fechar", "Fechar"),
    COPY("Copy", "Copiar", "Copiar");

    private final Words words;

    ProvingText(String english, String brazilian, String european) {
        words = Words.of(english, brazilian, european);
    }

    @Override
    public Words words() {
        return words;
    }
}
