/** Error measures of pictures and confidence intervals of measured costs. Independent of all other packages. */
package nephele.engine.measure;
