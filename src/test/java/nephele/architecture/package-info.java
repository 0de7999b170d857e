/**
 * The table of dependencies and the house style as rules, the names and links of the documents, and planted violations
 * that each rule must find.
 */
package nephele.architecture;
