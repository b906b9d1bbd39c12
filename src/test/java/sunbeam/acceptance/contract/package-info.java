/**
 * What users and scripts rely on, whatever the program is like inside: values of maps, lists, pictures and periods against
 * truths or a second path, scans against other programs, exit codes and lines about bad input. Few and fast.
 */
package sunbeam.acceptance.contract;
